// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/tile_zones.h"

#include <algorithm>

#include "engine/products/streets/ground/ground.h"
#include "kernels/morphology/outward_drops.h"

namespace ilot {

TileZones::TileZones(const TileLayers& layers, const char* layer)
    : layers_(layers), layer_(layer), borders_(layers.grid), zones_(layers.grid.count()) {}

void TileZones::find(std::size_t tile, const Image& image, Height lambda, OutwardDrops drops_wanted) {
  const TileFrame frame = tile_frame(layers_.grid, tile);
  const ZoneRuns runs = zone_runs(image, lambda, Adjacency::eight);
  const std::vector<std::uint32_t> on_border = borders_.record(tile, runs, image);
  std::vector<Zone> zones(on_border.size());
  for_each_run(runs, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    Zone& z = zones[zone];
    if (z.pixels == 0) z.first = std::uint64_t{frame.y + y} * layers_.grid.width + frame.x + run.from;
    z.pixels += run.to - run.from;
    z.on_border = on_border[zone];
  });
  const PixelLabels labels = painted(runs);
  if (drops_wanted == OutwardDrops::counted) {
    const std::vector<std::int32_t> drops = outward_drops(image, labels, lambda);
    for (std::size_t z = 1; z < zones.size(); ++z) zones[z].drops = drops[z];
  }
  zones_[tile] = std::move(zones);
  layers_.write(layer_, tile, {labels.width, labels.height, std::vector<Height>(labels.of.begin(), labels.of.end())});
}

void TileZones::join(Height lambda) {
  borders_.join(lambda, Adjacency::eight);
  first_.assign(1, borders_.count() + 1);
  for (const std::vector<Zone>& zones : zones_)
    first_.push_back(first_.back() + static_cast<std::uint32_t>(zones.size()));
}

// A zone on a border has the number of the zone to which it is joined. Another zone has a number of its own.
std::uint32_t TileZones::number(std::size_t tile, std::size_t zone) const {
  const std::uint32_t on_border = zones_[tile][zone].on_border;
  return on_border != 0 ? borders_.number(tile, on_border) + 1 : first_[tile] + static_cast<std::uint32_t>(zone);
}

std::vector<std::uint32_t> TileZones::numbers_of(std::size_t tile) const {
  std::vector<std::uint32_t> numbers(zones_[tile].size(), 0);
  for (std::size_t z = 1; z < numbers.size(); ++z) numbers[z] = number(tile, z);
  return numbers;
}

std::vector<std::uint32_t> TileZones::numbers_at(std::int64_t row, std::int64_t column) const {
  const std::size_t tile = layers_.grid.tile_at(row, column);
  return tile == kNoTile ? std::vector<std::uint32_t>{} : numbers_of(tile);
}

// Returns true where the tiles of this range contain two zones or more.
bool TileZones::has_two_zones(std::int64_t from_column, std::int64_t to_column, std::int64_t from_row,
                              std::int64_t to_row) const {
  std::uint32_t seen = 0;
  for (std::int64_t row = from_row; row <= to_row; ++row)
    for (std::int64_t column = from_column; column <= to_column; ++column)
      for (const std::uint32_t n : numbers_at(row, column)) {
        if (n == 0 || n == seen) continue;
        if (seen != 0) return true;
        seen = n;
      }
  return false;
}

Image TileZones::around(std::size_t tile, std::uint32_t halo) const {
  const TileGrid& grid = layers_.grid;
  const TileFrame frame = tile_frame(grid, tile);
  const std::int64_t side = grid.side, x = std::int64_t{frame.x} - halo, y = std::int64_t{frame.y} - halo;
  const std::int64_t from_column = std::max<std::int64_t>(x, 0) / side, from_row = std::max<std::int64_t>(y, 0) / side;
  const std::int64_t to_column = (std::min<std::int64_t>(frame.x + frame.width + halo, grid.width) - 1) / side;
  const std::int64_t to_row = (std::min<std::int64_t>(frame.y + frame.height + halo, grid.height) - 1) / side;
  if (!has_two_zones(from_column, to_column, from_row, to_row)) return {};
  Image image = layer_around(layers_, layer_, tile, halo);
  for (std::int64_t row = from_row; row <= to_row; ++row)
    for (std::int64_t column = from_column; column <= to_column; ++column) {
      const std::vector<std::uint32_t> numbers = numbers_at(row, column);
      if (numbers.empty()) continue;  // absent
      const std::int64_t u0 = std::max<std::int64_t>(column * side - x, 0),
                         v0 = std::max<std::int64_t>(row * side - y, 0);
      const std::int64_t u1 = std::min<std::int64_t>((column + 1) * side - x, image.width),
                         v1 = std::min<std::int64_t>((row + 1) * side - y, image.height);
      for (std::int64_t v = v0; v < v1; ++v) {
        Height* line = image.values.data() + v * image.width;
        for (std::int64_t u = u0; u < u1; ++u)
          if (line[u] > 0) line[u] = static_cast<Height>(numbers[static_cast<std::size_t>(line[u])]);
      }
    }
  return image;
}

// All zones on tile borders, joined, and those of the other zones that are not far smaller than the largest zone of
// their tile.
std::vector<TileZones::Candidate> TileZones::candidates(const TileGroups& groups) const {
  std::vector<Candidate> all;
  for (std::uint32_t n = 0; n < borders_.count(); ++n) all.push_back({UINT64_MAX, 0, borders_.drops(n), 0, 0});
  for (std::size_t t = 0; t < zones_.size(); ++t) {
    std::uint64_t most = 0;
    for (const Zone& z : zones_[t]) most = std::max<std::uint64_t>(most, z.pixels);
    for (std::size_t i = 1; i < zones_[t].size(); ++i) {
      const Zone& z = zones_[t][i];
      if (z.on_border == 0) {
        if (z.pixels * kComparableZones >= most)
          all.push_back({z.first, z.pixels, z.drops, groups.of[t], number(t, i)});
        continue;
      }
      Candidate& joined = all[borders_.number(t, z.on_border)];
      joined = {std::min(joined.first, z.first), joined.pixels + z.pixels, joined.drops + z.drops, groups.of[t],
                number(t, i)};
    }
  }
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.first < b.first; });
  return all;
}

GroundOfGroups TileZones::ground(const TileGroups& groups) const {
  const std::vector<Candidate> all = candidates(groups);
  std::vector<std::uint64_t> most(groups.count + 1, 0);
  for (const Candidate& c : all) most[c.group] = std::max(most[c.group], c.pixels);
  GroundOfGroups found{std::vector<std::uint32_t>(groups.count + 1, 0), {}, {}};
  std::vector<GroundRank> best(groups.count + 1);
  for (const Candidate& c : all) {
    const GroundRank rank = ground_rank(c.pixels, c.drops, most[c.group]);
    if (rank <= best[c.group]) continue;
    best[c.group] = rank;
    found.of_group[c.group] = c.number;
  }
  for (const Candidate& c : all) {
    if (c.number == found.of_group[c.group])
      found.taken.push_back(c.pixels);
    else if (c.pixels * kComparableZones >= most[c.group])
      found.left_out.push_back(c.pixels);
  }
  std::sort(found.left_out.rbegin(), found.left_out.rend());
  return found;
}

}  // namespace ilot
