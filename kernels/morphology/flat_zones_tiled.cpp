// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/flat_zones_tiled.h"

#include <cstdlib>

#include "kernels/core/union_find.h"
#include "kernels/morphology/border_pixels.h"
#include "kernels/morphology/zone_runs.h"
#include "kernels/rasters/tiles.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesOfZone = 24;  // parent, first pixel, root, number
constexpr std::size_t kPixelsOfRun = 128;   // of a tile whose runs are kept: fewest pixels per run

// The record of a tile: for each of its zones the first pixel in the whole image and the size ([0] = pixels without a
// zone), and the heights and zones of its border.
struct TileZones {
  std::vector<std::uint64_t> first, size;
  std::vector<Height> heights;
  std::vector<std::uint32_t> zones;
};

TileZones zones_of_tile(const TileGrid& grid, std::size_t tile, const Image& image, const ZoneRuns& runs) {
  const TileFrame frame = tile_frame(grid, tile);
  const Perimeter perimeter{frame.width, frame.height};
  TileZones recorded{std::vector<std::uint64_t>(runs.count + 1, UINT64_MAX),
                     std::vector<std::uint64_t>(runs.count + 1, 0), heights_on(perimeter, image),
                     std::vector<std::uint32_t>(perimeter.size(), 0)};
  recorded.size[0] = image.size();
  for_each_run(runs, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    const std::uint64_t first = std::uint64_t{frame.y + y} * grid.width + frame.x + run.from;
    recorded.first[zone] = std::min(recorded.first[zone], first);
    recorded.size[zone] += run.to - run.from;
    recorded.size[0] -= run.to - run.from;
    if (y == 0 || y + 1 == frame.height)
      for (std::uint32_t x = run.from; x < run.to; ++x) recorded.zones[perimeter.index(x, y)] = zone;
    if (run.from == 0) recorded.zones[perimeter.index(0, y)] = zone;
    if (run.to == frame.width) recorded.zones[perimeter.index(frame.width - 1, y)] = zone;
  });
  return recorded;
}

// The zones of all tiles as one list: zone z of tile t is first[t] + z - 1.
struct ZoneList {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> number;  // in the whole image, from 1
  std::uint32_t count = 0;
};

void join_across_borders(const TileGrid& grid, const std::vector<TileZones>& recorded, const ZoneList& list,
                         Height lambda, Adjacency adjacency, UnionFind& sets) {
  const BorderPixels pixels(grid);
  for (std::size_t t = 0; t < recorded.size(); ++t) {
    for (std::uint32_t i = 0; i < recorded[t].zones.size(); ++i) {
      if (recorded[t].zones[i] == 0) continue;
      pixels.for_beyond(pixels.first(t) + i, adjacency, [&](std::uint32_t q) {
        const std::size_t u = pixels.tile_of(q);
        const std::uint32_t j = q - pixels.first(u);
        if (recorded[u].zones[j] == 0) return;
        if (std::abs(std::int64_t{recorded[t].heights[i]} - recorded[u].heights[j]) <= lambda)
          sets.unite(static_cast<std::uint32_t>(list.first[t] + recorded[t].zones[i] - 1),
                     static_cast<std::uint32_t>(list.first[u] + recorded[u].zones[j] - 1));
      });
    }
  }
}

// Numbers the sets by their first pixels.
void number_sets(const std::vector<TileZones>& recorded, UnionFind& sets, ZoneList& list) {
  std::vector<std::uint64_t> first(list.first.back(), UINT64_MAX);
  std::vector<std::uint32_t> roots;
  for (std::size_t t = 0; t < recorded.size(); ++t) {
    for (std::size_t z = 1; z < recorded[t].first.size(); ++z) {
      const auto at = static_cast<std::uint32_t>(list.first[t] + z - 1);
      const std::uint32_t root = sets.find(at);
      if (root == at) roots.push_back(root);
      first[root] = std::min(first[root], recorded[t].first[z]);
    }
  }
  std::sort(roots.begin(), roots.end(), [&](std::uint32_t a, std::uint32_t b) { return first[a] < first[b]; });
  list.number.resize(list.first.back());
  for (const std::uint32_t root : roots) list.number[root] = ++list.count;
  for (std::uint32_t at = 0; at < list.number.size(); ++at) list.number[at] = list.number[sets.find(at)];
}

ZoneList numbered(const TileGrid& grid, const std::vector<TileZones>& recorded, Height lambda, Adjacency adjacency) {
  ZoneList list{std::vector<std::size_t>(recorded.size() + 1, 0), {}};
  for (std::size_t t = 0; t < recorded.size(); ++t) list.first[t + 1] = list.first[t] + recorded[t].first.size() - 1;
  assert(list.first.back() < (std::size_t{1} << 32));
  need_bytes(grid, list.first.back() * kBytesOfZone);
  std::vector<std::uint32_t> parents(list.first.back());
  UnionFind sets(parents);
  join_across_borders(grid, recorded, list, lambda, adjacency, sets);
  number_sets(recorded, sets, list);
  return list;
}

}  // namespace

ZoneSizes flat_zones_tiled(const TileGrid& grid, Height lambda, Adjacency adjacency, const ReadTile& read,
                           const WriteLabels& write) {
  std::vector<TileZones> recorded(grid.count());
  std::vector<ZoneRuns> kept(grid.count());
  for_each_tile(grid, [&](std::size_t tile) {
    const Image image = read(tile);
    ZoneRuns runs = zone_runs(image, lambda, adjacency);
    recorded[tile] = zones_of_tile(grid, tile, image, runs);
    if (runs.runs.size() * kPixelsOfRun <= image.size()) kept[tile] = std::move(runs);
  });
  const ZoneList list = numbered(grid, recorded, lambda, adjacency);
  ZoneSizes sizes{std::vector<std::uint64_t>(std::size_t{list.count} + 1, 0)};
  for (std::size_t t = 0; t < recorded.size(); ++t) {
    sizes.pixels[0] += recorded[t].size[0];
    for (std::size_t z = 1; z < recorded[t].size.size(); ++z)
      sizes.pixels[list.number[list.first[t] + z - 1]] += recorded[t].size[z];
  }
  for_each_tile(grid, [&](std::size_t tile) {
    ZoneRuns runs = kept[tile].height > 0 ? std::move(kept[tile]) : zone_runs(read(tile), lambda, adjacency);
    for (std::uint32_t& zone : runs.zone) zone = list.number[list.first[tile] + zone - 1];
    runs.count = list.count;
    write(tile, painted(runs));
  });
  return sizes;
}

}  // namespace ilot
