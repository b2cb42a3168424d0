// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/tile_zones.h"

#include <algorithm>

namespace ilot {

TileZones::TileZones(const TileLayers& layers, const char* layer)
    : layers_(layers), layer_(layer), borders_(layers.grid), zones_(layers.grid.count()) {}

void TileZones::find(std::size_t tile, const Image& image, Height lambda) {
  const ZoneRuns runs = zone_runs(image, lambda, Adjacency::eight);
  const std::vector<std::uint32_t> on_border = borders_.record(tile, runs, image);
  std::vector<Zone> zones(on_border.size());
  for (std::size_t z = 0; z < zones.size(); ++z) zones[z].on_border = on_border[z];
  const PixelLabels labels = painted(runs);
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
}  // namespace ilot
