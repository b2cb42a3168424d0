// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/border_zones.h"

#include <cstdlib>

#include "kernels/core/union_find.h"
#include "kernels/morphology/outward_drops.h"

namespace ilot {

BorderZones::BorderZones(const TileGrid& grid) : pixels_(grid), recorded_(grid.count()), first_(grid.count() + 1, 0) {}

std::vector<std::uint32_t> BorderZones::record(std::size_t tile, const ZoneRuns& zones, const Image& image) {
  return record(tile, zones, heights_on(pixels_.perimeter(tile), image));
}

std::vector<std::uint32_t> BorderZones::record(std::size_t tile, const ZoneRuns& zones) {
  return record(tile, zones, std::vector<Height>{});
}

std::vector<std::uint32_t> BorderZones::record(std::size_t tile, const ZoneRuns& zones, std::vector<Height> heights) {
  const Perimeter perimeter = pixels_.perimeter(tile);
  const std::vector<std::uint8_t> on_border = zones_on_border(zones);
  std::vector<std::uint32_t> number(on_border.size(), 0);
  TileRecord recorded{std::move(heights), std::vector<std::uint32_t>(perimeter.size(), 0), 0};
  for (std::size_t z = 1; z < number.size(); ++z)
    if (on_border[z] != 0) number[z] = ++recorded.count;
  for_each_run(zones, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    if (number[zone] == 0) return;
    if (y == 0 || y + 1 == zones.height)
      for (std::uint32_t x = run.from; x < run.to; ++x) recorded.zones[perimeter.index(x, y)] = number[zone];
    if (run.from == 0) recorded.zones[perimeter.index(0, y)] = number[zone];
    if (run.to == zones.width) recorded.zones[perimeter.index(zones.width - 1, y)] = number[zone];
  });
  recorded_[tile] = std::move(recorded);
  return number;
}

void BorderZones::join(Height lambda, Adjacency adjacency) {
  for (std::size_t t = 0; t < recorded_.size(); ++t) first_[t + 1] = first_[t] + recorded_[t].count;
  numbers_.resize(first_.back());
  UnionFind sets(numbers_);
  std::vector<std::int32_t> drops(numbers_.size(), 0);
  for (std::size_t t = 0; t < recorded_.size(); ++t) {
    for (std::uint32_t i = 0; i < recorded_[t].zones.size(); ++i) {
      if (recorded_[t].zones[i] == 0) continue;
      const auto a = static_cast<std::uint32_t>(first_[t] + recorded_[t].zones[i] - 1);
      pixels_.for_beyond(pixels_.first(t) + i, adjacency, [&](std::uint32_t q) {
        const std::size_t u = pixels_.tile_of(q);
        const std::uint32_t j = q - pixels_.first(u);
        if (recorded_[u].zones[j] == 0) return;
        if (recorded_[t].heights.empty() ||
            std::abs(std::int64_t{recorded_[t].heights[i]} - recorded_[u].heights[j]) <= lambda)
          sets.unite(a, static_cast<std::uint32_t>(first_[u] + recorded_[u].zones[j] - 1));
        else
          drops[a] += outward_drop(recorded_[t].heights[i], recorded_[u].heights[j], lambda);
      });
    }
  }
  recorded_.clear();
  // A root is the first of its set, and a parent comes before its child.
  for (std::uint32_t z = 0; z < numbers_.size(); ++z) numbers_[z] = numbers_[z] == z ? count_++ : numbers_[numbers_[z]];
  drops_.assign(count_, 0);
  for (std::size_t z = 0; z < numbers_.size(); ++z) drops_[numbers_[z]] += drops[z];
}

}  // namespace ilot
