// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/core/types.h"
#include "scan/roofs/roof_partition.h"

namespace ilot::scan {

enum class RoofPart : std::uint8_t { roof, wall, floor };

// A flat face of a building. The first ring is its outline, counter-clockwise seen from outside. The others are holes,
// clockwise. Rings are lists of vertex indices and are not closed.
struct RoofFace {
  RoofPart part = RoofPart::roof;
  Plane plane;  // outward, in metres
  std::vector<std::vector<std::uint32_t>> rings;
};

// A closed surface: every edge belongs to two faces, which traverse it in opposite directions.
struct RoofSolid {
  std::vector<Vec3> vertices;  // metres, in the frame of the wings
  std::vector<RoofFace> faces;
};

// Builds the solid below the pieces and above the floor. It has roof faces, walls around the footprint and where
// neighbouring pieces differ in height, and the floor. Pieces of one plane that meet become one face, and so do walls.
// Only vertices that are a corner of some face are kept. All pieces must be higher than the floor.
RoofSolid build_solid(std::span<const RoofPiece> pieces, Integer floor);

// Describes what is wrong with a solid as a model of a building: open or crossed edges, faces or walls that touch only
// in a point or an edge, edges shorter than `least_edge`, roof faces narrower than `least_width` (twice the area
// divided by the perimeter). Returns nothing when the solid is sound. ISO 19107 forbids the first two faults.
std::optional<std::string_view> fault_of(const RoofSolid& solid, double least_edge, double least_width);

// Returns the area in square metres, without the holes.
double face_area(const RoofSolid& solid, const RoofFace& face);

// Returns whether a position is within the face, when both are seen along the normal of the face.
bool face_contains(const RoofSolid& solid, const RoofFace& face, Vec3 place);

}  // namespace ilot::scan
