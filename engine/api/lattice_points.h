// SPDX-License-Identifier: Apache-2.0
// Points of a user as kernels want them: whole steps around the middle of their box, along a space-filling curve.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "ilot/geometry.h"
#include "kernels/core/types.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

constexpr std::size_t kBatch = 4096;  // queries that one thread asks at once

// Steps along the longest side: sums of squares of two coordinates' difference stay below kMaxSquaredReach, and
// coordinates below what moments_of() takes.
constexpr double kLatticeSteps = 0x1p22;

// How far a point may lie from its place on the lattice, in steps.
constexpr double kMostRounding = 0.8660254037844387;

// The arrays are not kept. Coordinates are integers within 2^21 of the origin, arrays padded as Points asks.
struct LatticePoints {
  Vec3 origin;
  double step = 1;                   // units of the user's coordinates
  std::vector<float> x, y, z;        // in the order of the Morton code, then of the index
  std::vector<std::uint32_t> given;  // place here -> index as given

  Points view() const { return {x.data(), y.data(), z.data(), given.size()}; }
};

// Error (usage): step, sizes or coordinates that lattice_step() refuses, or a step too fine for the box. O(n log n).
LatticePoints lattice_points(const PointArrays& points, double step);

// A length of the user's in whole steps; `what` names it in the Error for one that is not above 0.
double in_steps(double length, double step, const char* what);

// Runs body on so many threads; 0 = all that the process may use. Error (usage) for others than 0 to 1024.
void on_threads(int threads, const std::function<void()>& body);

// The normals of all points, in their order, from k nearest neighbours within max_d2, a batch of points at a time.
std::vector<PackedNormal> normals_of_all(const NeighbourIndex& index, const NormalsParams& params);

// A component of a packed normal.
inline float unpacked(std::int16_t component) {
  return static_cast<float>(component) * (1.0f / 32767);
}

}  // namespace ilot
