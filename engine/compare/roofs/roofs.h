// SPDX-License-Identifier: Apache-2.0
// Compares found roofs with true ones: faces, neighbours, heights, outlines.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/compare/roofs/roof_surface.h"

namespace ilot {

struct RoofParams {
  double least_iou = 0.5;      // least intersection over union of the plans of partners, inclusive
  double most_angle_deg = 15;  // largest angle between the planes of partners
  double sample_m = 0.25;      // step of the lattice on which surfaces and outlines are compared
  double touching_m = 0.05;    // faces whose plans are this near to each other along `shared_m` are neighbours
  double shared_m = 0.25;
  double metres_per_unit = 1;
};

// A class of true faces by their area in space, in square metres. It ends where the class before begins.
struct RoofSizeClass {
  double from_m2 = 0;
  std::uint64_t truth = 0, matched = 0;
  std::uint64_t right_neighbours = 0;  // matched, with the same neighbours among matched faces as in the truth
};

struct RoofResult {
  std::uint64_t true_buildings = 0, found_buildings = 0;  // buildings that have roof faces
  std::uint64_t true_faces = 0, found_faces = 0, matched_faces = 0;
  std::array<RoofSizeClass, 4> classes{RoofSizeClass{10, 0, 0, 0}, {5, 0, 0, 0}, {2, 0, 0, 0}, {0, 0, 0, 0}};
  double rms_m = 0;    // vertical, of the found roof (highest face) to the true one, over the lattice points of both
  double covered = 0;  // share of the true roof's lattice points with a found roof above or below
  double hausdorff_m = 0;    // largest distance from a sample of one roof to the other, in both directions
  double outline_p95_m = 0;  // 95th percentile of the distance between the outlines of buildings, in both directions
};

// Faces are matched one to one in the order of the intersection over union of their plans (ties: the earlier true face,
// then the earlier found one). Neighbours are faces of one building. A matched true face has the right neighbours when
// the partners of its matched neighbours are exactly the neighbours of its partner among matched faces. Without found
// faces all distances are infinite.
RoofResult evaluate_roofs(std::span<const RoofFace> truth, std::span<const RoofFace> found,
                          const RoofParams& params = {});

}  // namespace ilot
