// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/columns.h"

#include <algorithm>
#include <map>

namespace ilot {
namespace {

// What is free together: pixels that touch, with bins in common.
struct Group {
  std::vector<std::size_t> pixels;
  Occupancy bins = 0;
  std::uint32_t x0 = UINT32_MAX, y0 = UINT32_MAX, x1 = 0, y1 = 0;
};

Group group_from(std::size_t first, const std::vector<Occupancy>& free, std::uint32_t width, std::uint32_t height,
                 std::vector<std::uint8_t>& seen) {
  Group group;
  group.pixels = {first};
  seen[first] = 1;
  for (std::size_t next = 0; next < group.pixels.size(); ++next) {
    const std::size_t p = group.pixels[next];
    const auto x = static_cast<std::uint32_t>(p % width), y = static_cast<std::uint32_t>(p / width);
    group.bins |= free[p];
    group.x0 = std::min(group.x0, x), group.x1 = std::max(group.x1, x);
    group.y0 = std::min(group.y0, y), group.y1 = std::max(group.y1, y);
    for (std::uint32_t v = std::max(1u, y) - 1; v <= std::min(height - 1, y + 1); ++v)
      for (std::uint32_t u = std::max(1u, x) - 1; u <= std::min(width - 1, x + 1); ++u) {
        const std::size_t q = std::size_t{v} * width + u;
        if (seen[q] != 0 || (free[q] & free[p]) == 0) continue;
        seen[q] = 1;
        group.pixels.push_back(q);
      }
  }
  return group;
}

}  // namespace

PixelLabels columns_of(const std::vector<Occupancy>& occupancy, std::uint32_t width, std::uint32_t height,
                       const RasterScale& scale, const ColumnParams& params) {
  PixelLabels columns{width, height, 0, std::vector<std::uint32_t>(occupancy.size(), 0)};
  const std::uint32_t widest = scale.pixels(params.widest);
  const auto least = static_cast<std::uint32_t>(params.least_run / scale.bin() + 0.5);
  const std::vector<Occupancy> free =
      free_bins(occupancy, width, height, {widest, widest + std::max(1u, scale.pixels(params.apart))});
  std::vector<std::uint8_t> seen(free.size(), 0);
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i] == 0 || seen[i] != 0) continue;
    const Group group = group_from(i, free, width, height, seen);
    const BinRun run = longest_run(group.bins);
    if (run.length < least || group.x1 - group.x0 > widest || group.y1 - group.y0 > widest) continue;
    ++columns.count;
    for (const std::size_t p : group.pixels)
      if ((free[p] & run.bins()) != 0) columns.of[p] = columns.count;
  }
  return columns;
}

std::vector<ColumnCut> cut_columns(const PixelLabels& columns, std::uint32_t least, PixelLabels& parts) {
  std::vector<ColumnCut> cuts;
  if (columns.count == 0) return cuts;
  std::vector<std::uint32_t> left(std::size_t{parts.count} + 1, 0);
  std::vector<std::map<std::uint32_t, std::uint32_t>> held(std::size_t{columns.count} + 1);  // pixels, by part
  for (std::size_t i = 0; i < parts.of.size(); ++i) {
    ++left[parts.of[i]];
    if (columns.of[i] != 0 && parts.of[i] != 0) ++held[columns.of[i]][parts.of[i]];
  }
  std::vector<std::uint32_t> becomes(held.size(), 0);
  for (std::size_t c = 1; c < held.size(); ++c) {
    const auto most = std::max_element(held[c].begin(), held[c].end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == held[c].end() || left[most->first] - most->second < least) continue;
    becomes[c] = ++parts.count;
    cuts.push_back({most->first, becomes[c]});
    for (auto& [part, pixels] : held[c]) {
      if (left[part] - pixels < least) pixels = 0;  // stays with its part
      left[part] -= pixels;
    }
  }
  for (std::size_t i = 0; i < parts.of.size(); ++i) {
    const std::uint32_t c = columns.of[i];
    if (c != 0 && parts.of[i] != 0 && becomes[c] != 0 && held[c].at(parts.of[i]) != 0) parts.of[i] = becomes[c];
  }
  return cuts;
}

}  // namespace ilot
