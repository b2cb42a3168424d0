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

// A flat face of a building. The first ring is its outline, counter-clockwise seen from outside; the others are holes,
// clockwise. Rings are numbers of vertices and not closed.
struct RoofFace {
  RoofPart part = RoofPart::roof;
  Plane plane;  // outward, in metres
  std::vector<std::vector<std::uint32_t>> rings;
};

// A closed surface: every edge belongs to two faces, which run along it in opposite directions.
struct RoofSolid {
  std::vector<Vec3> vertices;  // metres, in the frame of the wings
  std::vector<RoofFace> faces;
};

// The solid below the pieces and above the floor: roof faces, walls where neighbouring pieces differ in height and
// around the footprint, and the floor. Pieces of one plane that meet are one face, and so are walls; the vertices are
// those that a face needs as a corner. All pieces must be higher than the floor.
RoofSolid build_solid(std::span<const RoofPiece> pieces, Integer floor);

// What is wrong with a solid as a model of a building: open or crossed edges, faces or walls that touch in a point or
// an edge only, edges shorter than `least_edge`, roof faces narrower than `least_width` (twice the area over the
// perimeter). Nothing when it is sound. ISO 19107 forbids the first two.
std::optional<std::string_view> fault_of(const RoofSolid& solid, double least_edge, double least_width);

// Square metres, without the holes.
double face_area(const RoofSolid& solid, const RoofFace& face);

// Whether a place lies within the face, both seen along the face's normal.
bool face_contains(const RoofSolid& solid, const RoofFace& face, Vec3 place);

}  // namespace ilot::scan
