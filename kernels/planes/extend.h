// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/core/types.h"

namespace ilot {

// A plane that may be extended, in the frame and the units of the points.
struct ExtendedPlane {
  Plane plane;
  double epsilon = 0;  // of the plane wherever it is; a point takes the label only within this distance of the plane
};

struct ExtendParams {
  std::int64_t edge = 1;   // units; the cell is the cube of the points from 0 to edge
  std::int64_t reach = 1;  // units; planes whose points are within about this distance of each other touch
  double min_cos = 0;      // cosine of the greatest angle between two planes one of which takes points of the other
  double share = 0.5;      // part of the smaller epsilon of two planes within which the first keeps a surface
};

// Extends planes over the border of a cell. `core` says which points are in the cell; the others are around it and keep
// their labels. label: 0 = none, else 1 + index into `planes`. The order of the planes is their precedence.
//
// Where a plane outside the cell touches another plane inside it at a small angle, both belong to one surface that
// bends little, and the border between them should follow this surface and not the cell. Let the surface at a point be
// its neighbourhood's mean. Of the two planes, the one that comes first keeps the point while the surface is no
// farther from it than share times the smaller epsilon of the two, or nearer to it than to the other plane; else the
// other plane gets the point. The rule knows the two planes alone, so it is the same on both sides of the border of a
// cell. Points pass from plane to plane only in the part of the cell that is connected to the plane outside, and only
// within epsilon of the plane that takes them. Returns how many points changed. O(n log n); points far from the border
// of the cell cost little unless they change.
std::size_t extend_planes(Points points, std::span<const std::uint8_t> core, std::span<const ExtendedPlane> planes,
                          const ExtendParams& params, std::span<std::uint32_t> label);

}  // namespace ilot
