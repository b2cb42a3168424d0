// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/thin_parts.h"

#include <algorithm>
#include <cstdint>

#include "engine/products/streets/objects/columns.h"

namespace ilot {

bool stands_upright(Occupancy bins, const RasterScale& scale, const ColumnParams& params) {
  const auto least = static_cast<std::uint32_t>(params.least_run / scale.bin() + 0.5);
  return longest_run(bins).length >= std::max(1u, least);
}

void add_thin_parts(const Image& heights, const std::vector<Occupancy>& occupancy, const RasterScale& scale,
                    const ColumnParams& params, PixelLabels& parts) {
  const auto w = std::int64_t{parts.width}, h = std::int64_t{parts.height};
  std::vector<std::uint8_t> seen(parts.of.size(), 0);
  std::vector<std::size_t> group;
  for (std::size_t first = 0; first < parts.of.size(); ++first) {
    if (parts.of[first] != 0 || seen[first] != 0 || heights.values[first] == kNoHeight) continue;
    group.assign(1, first);
    seen[first] = 1;
    Occupancy bins = 0;
    for (std::size_t next = 0; next < group.size(); ++next) {
      const auto at = static_cast<std::int64_t>(group[next]);
      bins |= occupancy[group[next]];
      const std::int64_t x = at % w, y = at / w;
      for (std::int64_t v = std::max<std::int64_t>(0, y - kSamplingStep); v <= std::min(h - 1, y + kSamplingStep); ++v)
        for (std::int64_t u = std::max<std::int64_t>(0, x - kSamplingStep); u <= std::min(w - 1, x + kSamplingStep);
             ++u) {
          const auto q = static_cast<std::size_t>(v * w + u);
          if (parts.of[q] != 0 || seen[q] != 0 || heights.values[q] == kNoHeight) continue;
          seen[q] = 1;
          group.push_back(q);
        }
    }
    if (!stands_upright(bins, scale, params)) continue;
    ++parts.count;
    for (const std::size_t p : group) parts.of[p] = parts.count;
  }
}

}  // namespace ilot
