// SPDX-License-Identifier: Apache-2.0
// Places from one CRS in another, through PROJ.
#pragma once
#include <memory>
#include <span>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Longitude or easting comes first, as clouds have it. Thread-safe.
class CrsTransform {
 public:
  // Throws Error when PROJ knows no way from one to the other.
  CrsTransform(const Crs& from, const Crs& to);
  ~CrsTransform();

  // Places that cannot be moved become infinite.
  void apply(std::span<Vec3> places) const;

 private:
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

// The zone of UTM (WGS 84) that a place lies in. Throws Error outside of 80 degrees south to 84 north.
Crs utm_at(const Crs& crs, Vec3 place);

}  // namespace ilot
