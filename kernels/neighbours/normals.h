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

// A normal and the curvature of its neighbourhood, in 8 bytes. The unit vector is scaled to 32767 and rounded (0.002
// degrees). It points up (z > 0, or z = 0 and y > 0, or x > 0). All zero means no normal. curvature = l0 / (l0 + l1 +
// l2), scaled so that its greatest value, 1/3, is 65535.
struct PackedNormal {
  std::int16_t x = 0, y = 0, z = 0;
  std::uint16_t curvature = 0;
  friend bool operator==(const PackedNormal&, const PackedNormal&) = default;
};

// Packs a unit vector, turned to point up, and a curvature in [0, 1].
PackedNormal pack_normal(Vec3 unit, double curvature);

// Computes normals by principal component analysis of the k nearest neighbours of each query (an index into the
// points). There is no normal where fewer than three neighbours are within max_d2 or where they are on a line. reach2
// is as in knn(). The caller decides with it whether the given points were enough. Sums are exact integers relative to
// the query, so the bits depend only on the positions of the neighbours.
void normals(const NeighbourIndex& index, std::span<const std::uint32_t> queries, const NormalsParams& params,
             std::span<PackedNormal> out, std::span<std::int64_t> reach2);

// The same with neighbours (k per query) and reach2 that knn() found for these queries.
void normals_of_neighbours(Points points, std::span<const std::uint32_t> queries, int k,
                           std::span<const std::uint32_t> neighbours, std::span<const std::int64_t> reach2,
                           std::span<PackedNormal> out);

}  // namespace ilot
