// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "engine/settings/settings.h"
#include "kernels/neighbours/neighbour_index.h"

namespace ilot {

// What the parameters of a unit are chosen from, measured on its own points. In units of the points.
struct Sampling {
  double step = 0;   // median distance between neighbours on a surface: root of the area per point
  double noise = 0;  // standard deviation of points about their local surface, from the flat part of the unit
};

// From 512 to 1,023 points (all where there are fewer), evenly spread in their order, and their 16 nearest neighbours.
// {0, 0} for fewer than 16.
Sampling measure_sampling(const NeighbourIndex& index);

constexpr int kAutoMinPoints = 30;

// Parameters of plane extraction in units of the points.
struct PlaneParams {
  double epsilon = 0;
  double min_cos = 0;  // of normal_angle
  std::int64_t connectivity = 1;
  std::uint32_t min_points = 3;
};

// Settings where they are given, else: epsilon = 3.5 noise, at least 3 lattice units and a quarter of the step, at most
// 0.5 m; connectivity = 3 steps, at most `reach` (units), beyond which a unit does not know its surroundings;
// min_points = 30. unit_metres is the lattice unit in metres.
PlaneParams choose_plane_params(const PlanesSettings& settings, const Sampling& sampling, double unit_metres,
                                std::int64_t reach);

}  // namespace ilot
