// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/neighbours/normals.h"

namespace ilot {

// The nearest neighbours of every point as knn() gives them: k entries per point, kNoNeighbour where there are fewer.
struct NeighbourLists {
  std::span<const std::uint32_t> indices;
  std::uint32_t k = 0;
  std::span<const std::uint32_t> of(std::size_t i) const { return indices.subspan(i * k, k); }
};

struct Regions {
  std::vector<std::uint32_t> id;    // per point: 0 = none, else 1 to count
  std::uint32_t count = 0;          // regions are numbered by least curvature of their seed, ties by index
  std::vector<std::uint32_t> seed;  // per region: its point of least curvature, ties by index
};

struct PairGrowthParams {
  double min_cos = 0.9961946980917455;  // of the angle between two normals [5 degrees]
  double max_offset = 0;                // units; greatest step between the two local planes
  std::int64_t max_gap = 0;             // units; greatest distance between the two points
  std::uint32_t min_points = 3;         // smaller regions are dropped
};

// Region growing after Stamos and Boulaassal [Marchand 2018, I.3.1.2]. Neighbours p1, p2 are in one region when the
// angle between their normals is small, when they are near, and when max(|r12 . n1|, |r12 . n2|) <= max_offset. Here
// r12 joins the two points projected on their local planes (through the centroid of their neighbours). The criteria are
// symmetric and pairs are joined by union-find, so the regions do not depend on the order of growth. Points without a
// normal are in no region. O(n k).
Regions grow_by_pairs(Points points, std::span<const PackedNormal> normals, const NeighbourLists& neighbours,
                      const PairGrowthParams& params);

struct SmoothGrowthParams {
  double min_cos = 0.9993908270190958;  // of the angle between neighbouring normals [2 degrees]
  double max_curvature = 1.0 / 3;       // l0 / (l0 + l1 + l2); points above it are left out [no limit]
  std::int64_t max_gap = 0;             // units; greatest distance between neighbours
  std::uint32_t min_points = 3;         // smaller regions are dropped
};

// Region growing on normals alone [Boltcheva et al. 2019, 3.2.1]. The document starts from the point of least curvature
// and grows to neighbours while normals differ by at most 2 degrees, until no point is left. The regions are the
// connected components of the graph of such pairs, which union-find gives in any order. Seeds number the regions and
// start their planes. O(n k).
Regions grow_smooth(Points points, std::span<const PackedNormal> normals, const NeighbourLists& neighbours,
                    const SmoothGrowthParams& params);

}  // namespace ilot
