// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "engine/settings/settings.h"
#include "kernels/neighbours/neighbour_index.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

// The measured values from which the parameters of a cell are chosen. They come from its own points, in units of the
// points.
struct Sampling {
  double step = 0;   // median distance between neighbours on a surface: square root of the area per point
  double noise = 0;  // standard deviation of points about their local surface, from the flat part of the cell
};

// Measures 512 to 1,023 points (all where there are fewer), evenly spread in their order, and the 16 nearest neighbours
// of each. The result is {0, 0} for fewer than 16 points.
Sampling measure_sampling(const NeighbourIndex& index);

// The same, for points whose kSamplingNeighbours neighbours and reach2 are already known from knn().
constexpr int kSamplingNeighbours = 16;
Sampling measure_sampling(Points points, std::span<const std::uint32_t> neighbours,
                          std::span<const std::int64_t> reach2);

// The place from which a cell was seen, as far as its normals show it.
enum class SeenFrom : std::uint8_t { ground, air };

// The result is `ground` if more than a quarter of the known normals are within 17.5 degrees of the horizontal: these
// are walls. O(n).
SeenFrom seen_from(std::span<const PackedNormal> normals);

// Parameters of plane extraction in units of the points.
struct PlaneParams {
  double epsilon = 0;
  double normal_angle = 25;  // degrees
  bool noisy = false;        // epsilon is greater than 0.3 steps
  std::int64_t connectivity = 1;
  std::uint32_t min_points = 3;
};

// Uses the settings where they are given. The other values are as follows. epsilon is 3.5 noise, at least 3 lattice
// units and a quarter of the step, and at most 0.5 m. connectivity is 4 steps from the air and 6 from the ground,
// because a surface seen at a grazing angle or through glass has gaps of several steps; it is at most `reach` (units),
// beyond which the surroundings of a cell are not known. normal_angle is 25 degrees. From the air it is smaller where
// the noise makes epsilon large compared with the step: faces at a small angle to each other then lie within epsilon,
// and only normals separate them. It is then 25 degrees times the square of (a quarter of the step over epsilon), at
// least 10. min_points is the number of points on the smallest surface worth a plane: 1.2 m2 from the air, 12 to 200
// points; 50 cm2 from the ground, 30 to 200 points. unit_metres is the lattice unit in metres.
PlaneParams choose_plane_params(const PlanesSettings& settings, const Sampling& sampling, SeenFrom from,
                                double unit_metres, std::int64_t reach);

}  // namespace ilot
