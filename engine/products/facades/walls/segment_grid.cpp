// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/segment_grid.h"

#include <cmath>
#include <utility>

#include "kernels/geometry/flat_box.h"

namespace ilot {

WallExtent extent_of(const Segment& s, const FacadeAxes& axes, double metres) {
  const Vec3 middle = 0.5 * (s.min + s.max) - axes.origin, half = 0.5 * (s.max - s.min);
  const auto along = [&](Vec3 axis, double& low, double& high) {
    const double at = dot(middle, axis);
    const double reach = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
    low = (at - reach) * metres;
    high = (at + reach) * metres;
  };
  WallExtent e;
  along(axes.right, e.u0, e.u1);
  along(axes.up, e.v0, e.v1);
  const double w = dot(s.centroid - axes.origin, axes.out) * metres;
  e.w0 = e.w1 = w;
  return e;
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, std::vector<std::size_t> list, double metres)
    : segments_(segments), list_(std::move(list)), metres_(metres), grid_(kCell / metres) {
  // A box along the axes of the CRS meets the box of a wall only if its middle is near enough to it: within half of
  // its own diagonal along each of the three axes of the wall.
  // Derived: above the square root of 3, the ratio of a diagonal in space to a side.
  constexpr double kDiagonals = 1.8;
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const Segment& s = segments_[list_[k]];
    const Vec3 middle = 0.5 * (s.min + s.max);
    FlatBox box = FlatBox::none();
    box.add({middle.x, middle.y});
    grid_.add(static_cast<std::uint32_t>(k), box.grown(kDiagonals * 0.5 * norm(s.max - s.min)));
  }
}

std::vector<std::uint32_t> SegmentGrid::near(const FacadeAxes& axes, const WallExtent& e) const {
  // Derived: the rounding of coordinates in millimetres.
  constexpr double kCornerRounding = 0.001;  // metres
  FlatBox box = FlatBox::none();
  for (const double u : {e.u0, e.u1})
    for (const double v : {e.v0, e.v1})
      for (const double w : {e.w0, e.w1}) {
        const Vec3 p = axes.origin + (1 / metres_) * (u * axes.right + v * axes.up + w * axes.out);
        box.add({p.x, p.y});
      }
  return grid_.near(box.grown(kCornerRounding / metres_));
}

}  // namespace ilot
