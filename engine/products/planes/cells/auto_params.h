// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "engine/settings/settings.h"
#include "kernels/neighbours/neighbour_index.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

// What the parameters of a unit are chosen from, measured on its own points. In units of the points.
struct Sampling {
  double step = 0;   // median distance between neighbours on a surface: root of the area per point
  double noise = 0;  // standard deviation of points about their local surface, from the flat part of the unit
};

// From 512 to 1,023 points (all where there are fewer), evenly spread in their order, and their 16 nearest neighbours.
// {0, 0} for fewer than 16.
Sampling measure_sampling(const NeighbourIndex& index);

// The same where the kSamplingNeighbours neighbours of every point and reach2 are known from knn() already.
constexpr int kSamplingNeighbours = 16;
Sampling measure_sampling(Points points, std::span<const std::uint32_t> neighbours,
                          std::span<const std::int64_t> reach2);

// Where a unit was seen from, as far as its normals tell.
enum class SeenFrom : std::uint8_t { ground, air };

// From the ground where more than a quarter of the known normals are within 17.5 degrees of the level: walls. O(n).
SeenFrom seen_from(std::span<const PackedNormal> normals);

// Parameters of plane extraction in units of the points.
struct PlaneParams {
  double epsilon = 0;
  double normal_angle = 25;  // degrees
  bool noisy = false;        // epsilon is wider than 0.3 steps
  std::int64_t connectivity = 1;
  std::uint32_t min_points = 3;
};

// Settings where they are given, else:
//   epsilon = 3.5 noise, at least 3 lattice units and a quarter of the step, at most 0.5 m;
//   connectivity = 4 steps from the air, 6 from the ground (a surface seen at a grazing angle or through glass has gaps
//   of several steps), at most `reach` (units), beyond which a unit does not know its surroundings;
//   normal_angle = 25 degrees; where the noise makes epsilon wide beside the step, so that faces that lean little from
//   each other lie within it and only normals tell them apart, less from the air: 25 degrees times the square of a
//   quarter of the step over epsilon, at least 10;
//   min_points = as many as lie on the smallest surface worth a plane: 1.2 m2 from the air, 12 to 200 points; 50 cm2
//   from the ground, 30 to 200 points.
// unit_metres is the lattice unit in metres.
PlaneParams choose_plane_params(const PlanesSettings& settings, const Sampling& sampling, SeenFrom from,
                                double unit_metres, std::int64_t reach);

}  // namespace ilot
