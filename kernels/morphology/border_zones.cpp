// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/border_zones.h"

#include <cstdlib>

#include "kernels/core/union_find.h"
#include "kernels/morphology/zone_falls.h"

namespace ilot {

BorderZones::BorderZones(const TileGrid& grid) : pixels_(grid), told_(grid.count()), first_(grid.count() + 1, 0) {}

std::vector<std::uint32_t> BorderZones::tell(std::size_t tile, const ZoneRuns& zones, const Image& image) {
  return tell(tile, zones, heights_on(pixels_.perimeter(tile), image));
}

std::vector<std::uint32_t> BorderZones::tell(std::size_t tile, const ZoneRuns& zones) {
  return tell(tile, zones, std::vector<Height>{});
}

std::vector<std::uint32_t> BorderZones::tell(std::size_t tile, const ZoneRuns& zones, std::vector<Height> heights) {
  const Perimeter perimeter = pixels_.perimeter(tile);
  const std::vector<std::uint8_t> on_border = zones_on_border(zones);
  std::vector<std::uint32_t> number(on_border.size(), 0);
  Told told{std::move(heights), std::vector<std::uint32_t>(perimeter.size(), 0), 0};
  for (std::size_t z = 1; z < number.size(); ++z)
    if (on_border[z] != 0) number[z] = ++told.count;
  for_each_run(zones, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    if (number[zone] == 0) return;
    if (y == 0 || y + 1 == zones.height)
      for (std::uint32_t x = run.from; x < run.to; ++x) told.zones[perimeter.index(x, y)] = number[zone];
    if (run.from == 0) told.zones[perimeter.index(0, y)] = number[zone];
    if (run.to == zones.width) told.zones[perimeter.index(zones.width - 1, y)] = number[zone];
  });
  told_[tile] = std::move(told);
  return number;
}

void BorderZones::join(Height lambda, Adjacency adjacency) {
  for (std::size_t t = 0; t < told_.size(); ++t) first_[t + 1] = first_[t] + told_[t].count;
  numbers_.resize(first_.back());
  UnionFind sets(numbers_);
  std::vector<std::int32_t> falls(numbers_.size(), 0);
  for (std::size_t t = 0; t < told_.size(); ++t) {
    for (std::uint32_t i = 0; i < told_[t].zones.size(); ++i) {
      if (told_[t].zones[i] == 0) continue;
      const auto a = static_cast<std::uint32_t>(first_[t] + told_[t].zones[i] - 1);
      pixels_.for_beyond(pixels_.first(t) + i, adjacency, [&](std::uint32_t q) {
        const std::size_t u = pixels_.tile_of(q);
        const std::uint32_t j = q - pixels_.first(u);
        if (told_[u].zones[j] == 0) return;
        if (told_[t].heights.empty() || std::abs(std::int64_t{told_[t].heights[i]} - told_[u].heights[j]) <= lambda)
          sets.unite(a, static_cast<std::uint32_t>(first_[u] + told_[u].zones[j] - 1));
        else
          falls[a] += fall(told_[t].heights[i], told_[u].heights[j], lambda);
      });
    }
  }
  told_.clear();
  // A root is the first of its set, and a parent comes before its child.
  for (std::uint32_t z = 0; z < numbers_.size(); ++z) numbers_[z] = numbers_[z] == z ? count_++ : numbers_[numbers_[z]];
  falls_.assign(count_, 0);
  for (std::size_t z = 0; z < numbers_.size(); ++z) falls_[numbers_[z]] += falls[z];
}

}  // namespace ilot
