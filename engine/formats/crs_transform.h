// SPDX-License-Identifier: Apache-2.0
// Transforms places from one CRS to another with PROJ.
#pragma once
#include <memory>
#include <span>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Longitude or easting comes first, as in clouds. Thread-safe.
class CrsTransform {
 public:
  // Throws Error when PROJ knows no transformation between the two.
  CrsTransform(const Crs& from, const Crs& to);
  ~CrsTransform();

  // Places that cannot be transformed become infinite.
  void apply(std::span<Vec3> places) const;

 private:
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

// Returns the zone of UTM (WGS 84) that contains a place. Throws Error outside 80 degrees south to 84 degrees north.
Crs utm_at(const Crs& crs, Vec3 place);

}  // namespace ilot
