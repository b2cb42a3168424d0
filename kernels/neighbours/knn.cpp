// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/knn.h"

#include <cassert>

#include "kernels/neighbours/knn_body.h"

namespace ilot {

void knn(const NeighbourIndex& index, std::span<const std::uint32_t> queries, const KnnParams& params,
         std::span<std::uint32_t> neighbours, std::span<std::int64_t> reach2) {
  assert(params.k >= 1 && params.k <= kMaxNeighbours);
  assert(params.max_d2 >= 0 && params.max_d2 <= kMaxSquaredReach);
  assert(neighbours.size() == queries.size() * static_cast<std::size_t>(params.k) && reach2.size() == queries.size());
  constexpr int kMaxLevels = 12;  // 8^13 points
  const float* boxes[kMaxLevels];
  const int levels = static_cast<int>(index.boxes.size());
  assert(levels <= kMaxLevels);
  for (int i = 0; i < levels; ++i) boxes[i] = index.boxes[static_cast<std::size_t>(i)].data();
  simd::kKnn.best().knn({index.points.x, index.points.y, index.points.z, static_cast<std::uint32_t>(index.points.size),
                         boxes, levels, queries.data(), static_cast<std::uint32_t>(queries.size()), params.k,
                         params.max_d2, neighbours.data(), reach2.data()});
}

}  // namespace ilot
