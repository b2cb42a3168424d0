// SPDX-License-Identifier: Apache-2.0
// Where a scene is on the earth.
#pragma once
#include <array>
#include <memory>
#include <span>

#include "engine/deliverables/exports/export_frame.h"
#include "engine/formats/crs_transform.h"

namespace ilot {

// A frame in metres at the origin of an export. With a CRS its axes are east, north and up on the ellipsoid there, and
// every place is transformed by PROJ on its own, so the scale and the convergence of the map have no part in it.
// Without a CRS its axes are those of the coordinates.
class Placement {
 public:
  // `geoid_m` is added to heights: the height of the geoid (or of the datum of heights) above the ellipsoid. Throws a
  // usage Error when the CRS has no way to the earth.
  Placement(const ExportFrame& frame, double geoid_m);

  bool on_earth() const { return transform_ != nullptr; }
  void apply(std::span<Vec3> places) const;  // from the CRS into the frame

  // The frame in EPSG:4978, column by column, as 3D Tiles have it; only when on_earth().
  std::array<double, 16> to_earth() const;

 private:
  void to_4978(std::span<Vec3> places) const;

  ExportFrame frame_;
  double geoid_m_ = 0, height_unit_ = 1;  // metres; metres of a unit of the heights that PROJ reads
  std::shared_ptr<const CrsTransform> transform_;
  Vec3 centre_, east_, north_, up_;
};

}  // namespace ilot
