// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/neighbours/neighbour_index.h"

namespace ilot {

struct NormalsParams {
  int k = 16;               // neighbours, the point itself included; 3 to kMaxNeighbours
  std::int64_t max_d2 = 0;  // squared units: neighbours lie within this
};

// A normal and the flatness of its neighbourhood, 8 bytes. Unit vector scaled to 32767 and rounded (0.002 degrees),
// pointing up (z > 0, or z = 0 and y > 0, or x > 0); all zero = none. curvature = l0 / (l0 + l1 + l2) scaled so that
// its greatest value, 1/3, is 65535.
struct PackedNormal {
  std::int16_t x = 0, y = 0, z = 0;
  std::uint16_t curvature = 0;
  friend bool operator==(const PackedNormal&, const PackedNormal&) = default;
};

// The normal of a unit vector, turned to point up, and a curvature in [0, 1].
PackedNormal pack_normal(Vec3 unit, double curvature);

// Principal component analysis of the k nearest neighbours of each query (an index into the points). None where fewer
// than three neighbours lie within max_d2 or they lie on a line. reach2 as in knn(): the caller decides whether the
// points it gave were enough. Sums are exact integers relative to the query, so the bits depend on nothing but the
// neighbours' positions.
void normals(const NeighbourIndex& index, std::span<const std::uint32_t> queries, const NormalsParams& params,
             std::span<PackedNormal> out, std::span<std::int64_t> reach2);

// The same from neighbours and reach2 that knn() found for these queries, k a query.
void normals_of_neighbours(Points points, std::span<const std::uint32_t> queries, int k,
                           std::span<const std::uint32_t> neighbours, std::span<const std::int64_t> reach2,
                           std::span<PackedNormal> out);

}  // namespace ilot
