// SPDX-License-Identifier: Apache-2.0
// How far a face may rise above its points and fall below them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

struct FaceLimits {
  double step = 0;         // metres between points
  double overshoot = 0.5;  // metres above its highest point that a face may rise; a steep face: three steps' rise
  double ground = 0;       // metres above the anchor
};

// How far a face may rise above its highest point, in metres. Its tip, or a face that has narrowed to nothing, is as
// steep as the rest and may be without a point for some steps.
double most_overshoot(const RoofPlane& plane, const FaceLimits& limits);

// Returns by how many metres a face is higher than it may be at a place (metres from the anchor); 0 or less where it is
// not.
double too_high(const RoofPlane& plane, FlatPoint at, const FaceLimits& limits);

// Returns by how many metres a face is lower than it may be; 0 or less where it is not. A face may fall to a storey
// below the ground, and as far below its lowest point as it may rise above its highest one.
double too_low(const RoofPlane& plane, FlatPoint at, const FaceLimits& limits);

// Returns the numbers of the planes (from 0, ascending) that are too low at a corner of a cell with their label.
std::vector<std::uint32_t> falling_planes(const RoofPlanes& planes, const Partition& cells,
                                          std::span<const std::uint32_t> label, const FaceLimits& limits);

// Returns a line over the whole outline where a plane has the height of its lowest point.
FlatEdge end_of_points(const RoofPlane& plane, const SitePolygon& outline);

// Gives cells that are too low on their planes a level one at the height of the plane's lowest point. Such planes are
// added; no point lies on them.
void level_fallen(const Partition& cells, const FaceLimits& limits, RoofPlanes& planes,
                  std::vector<std::uint32_t>& label);

}  // namespace ilot
