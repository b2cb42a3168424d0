// SPDX-License-Identifier: Apache-2.0
// Nearest neighbours and normals of points in memory.
//
//   const ilot::NeighbourTable near = ilot::nearest_neighbours({x, y, z}, {.count = 8});
//   const std::uint32_t second = near.index[8 * i + 1];  // the nearest other point of point i
//
// Functions own nothing and keep nothing; several threads may call them at once. Any order of points gives the same
// neighbours, at the same speed: points are sorted along a space-filling curve first. O(n log n). Working memory: about
// 50 bytes a point beside the results.
#pragma once
#include <cstdint>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

constexpr std::uint32_t kNoPoint = 0xffffffffu;

struct NeighbourOptions {
  int count = 16;           // neighbours, the point itself included: 1 to 64, for normals 3 to 64
  double max_distance = 0;  // neighbours lie within it, units of the coordinates; 0 = however far
  double step = 0;          // of the lattice (geometry.h); 0 = lattice_step(points)
  int threads = 0;          // 0 = all that the process may use; no result depends on it
};

// `count` entries a point, the nearest first, of equally near ones the one with the smaller index; the point itself is
// the first, but where more than `count` points are at its place. Where fewer lie within the distance the rest is
// kNoPoint with an infinite distance.
struct NeighbourTable {
  int count = 0;
  std::vector<std::uint32_t> index;  // of the points as given
  std::vector<float> distance;       // units of the coordinates, between the points as given
};

// Which points are the nearest is exact on the lattice (geometry.h): of two neighbours whose distances differ by less
// than two steps either may be taken. Error (usage) for options out of range and what lattice_step refuses.
NeighbourTable nearest_neighbours(const PointArrays& points, const NeighbourOptions& options = {});

// One entry a point.
struct NormalArrays {
  std::vector<float> x, y, z;    // unit length, pointing up, to 0.002 degrees; 0, 0, 0 = none
  std::vector<float> curvature;  // l0 / (l0 + l1 + l2) of the neighbourhood: 0 flat, 1/3 a ball
};

// The direction in which the nearest points vary least (principal components). None where fewer than three points lie
// within the distance, or all of them on a line.
NormalArrays estimate_normals(const PointArrays& points, const NeighbourOptions& options = {});

}  // namespace ilot
