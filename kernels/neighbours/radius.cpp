// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/radius.h"

#include <cassert>
#include <numeric>

#include "kernels/neighbours/knn.h"
#include "kernels/simd/dispatch.h"

namespace ilot {

RadiusNeighbours radius_search(const NeighbourIndex& index, std::span<const std::uint32_t> queries,
                               std::int64_t radius2) {
  assert(radius2 >= 0 && radius2 <= kMaxSquaredReach);
  std::vector<const float*> boxes;
  for (const auto& level : index.boxes) boxes.push_back(level.data());
  const Points& p = index.points;
  RadiusNeighbours result{{0}, {}};
  result.begin.reserve(queries.size() + 1);
  std::vector<std::uint32_t> room(1 << 14), counts(queries.size());
  while (!queries.empty()) {
    const std::uint32_t answered = simd::table().radius_search(
        {p.x, p.y, p.z, static_cast<std::uint32_t>(p.size), boxes.data(), static_cast<int>(boxes.size()),
         queries.data(), static_cast<std::uint32_t>(queries.size()), radius2, counts.data(), room.data(),
         static_cast<std::uint32_t>(room.size())});
    const auto found = std::accumulate(counts.begin(), counts.begin() + answered, std::size_t{0});
    result.index.insert(result.index.end(), room.begin(), room.begin() + static_cast<std::ptrdiff_t>(found));
    for (std::uint32_t q = 0; q < answered; ++q) result.begin.push_back(result.begin.back() + counts[q]);
    queries = queries.subspan(answered);
    if (answered == 0) room.resize(2 * room.size());
  }
  return result;
}

}  // namespace ilot
