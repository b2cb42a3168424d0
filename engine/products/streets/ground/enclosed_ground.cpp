// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/enclosed_ground.h"

#include <algorithm>

namespace ilot {
namespace {

// Codes of the mask while parts are undecided: pixels of a part that reaches the border of its tile, with a height and
// without one.
constexpr Height kUndecided = 2, kUndecidedMissing = 3;

class Enclosing {
 public:
  Enclosing(const TileLayers& layers, const char* zones_layer, const TileZones& zones)
      : layers_(layers), zones_layer_(zones_layer), zones_(zones), borders_(layers.grid), open_(layers.grid.count()) {}

  // Finds the ground of a tile and what it encloses within the tile.
  void find(std::size_t tile, std::uint32_t ground) {
    const std::vector<std::uint32_t> numbers = zones_.numbers_of(tile);
    const Image labels = layer_tile(layers_, zones_layer_, tile);
    std::vector<std::uint8_t> is_outside(numbers.size()), outside(labels.size());
    for (std::size_t z = 0; z < numbers.size(); ++z) is_outside[z] = z == 0 || numbers[z] != ground;
    for (std::size_t i = 0; i < outside.size(); ++i)
      outside[i] = is_outside[static_cast<std::size_t>(labels.values[i])];
    const ZoneRuns parts = flagged_runs(labels.width, labels.height, outside, Adjacency::four);
    const std::vector<std::uint32_t> on_border = borders_.record(tile, parts);
    open_[tile].assign(*std::max_element(on_border.begin(), on_border.end()) + std::size_t{1}, 0);
    open_at_ends(tile, parts, on_border);
    const Image filled = layer_tile(layers_, "filled", tile);
    Image mask = filled_image(filled.width, filled.height, 1);
    for_each_run(parts, [&](std::uint32_t part, std::uint32_t y, PixelRun run) {
      const std::size_t row = std::size_t{y} * mask.width;
      const bool undecided = on_border[part] != 0;
      for (std::size_t i = row + run.from; i < row + run.to; ++i) {
        const bool missing = filled.values[i] == kNoHeight;
        mask.values[i] = undecided ? (missing ? kUndecidedMissing : kUndecided) : !missing;
      }
    });
    layers_.write("mask", tile, mask);
  }

  void join() {
    borders_.join(0, Adjacency::four);
    joined_open_.assign(borders_.count(), 0);
    for (std::size_t t = 0; t < open_.size(); ++t)
      for (std::uint32_t part = 1; part < open_[t].size(); ++part)
        joined_open_[borders_.number(t, part)] |= open_[t][part];
  }

  // Decides the remaining parts, which are those on the border of the tile. They come in the order in which find()
  // recorded them.
  void decide(std::size_t tile) const {
    if (open_[tile].size() < 2) return;
    Image mask = layer_tile(layers_, "mask", tile);
    std::vector<std::uint8_t> left(mask.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = mask.values[i] >= kUndecided;
    const ZoneRuns parts = flagged_runs(mask.width, mask.height, left, Adjacency::four);
    for_each_run(parts, [&](std::uint32_t part, std::uint32_t y, PixelRun run) {
      const bool enclosed = joined_open_[borders_.number(tile, part)] == 0;
      const std::size_t row = std::size_t{y} * mask.width;
      for (std::size_t i = row + run.from; i < row + run.to; ++i)
        mask.values[i] = enclosed && mask.values[i] == kUndecided;
    });
    layers_.write("mask", tile, mask);
  }

 private:
  void open_at_ends(std::size_t tile, const ZoneRuns& parts, const std::vector<std::uint32_t>& on_border) {
    const TileFrame frame = tile_frame(layers_.grid, tile);
    const auto open_at = [&](std::uint32_t part, std::uint32_t x, std::uint32_t y) {
      std::uint8_t& open = open_[tile][on_border[part]];
      if (open == 0) open = layers_.grid.ends_at(std::int64_t{frame.x} + x, std::int64_t{frame.y} + y);
    };
    for_each_run(parts, [&](std::uint32_t part, std::uint32_t y, PixelRun run) {
      if (y == 0 || y + 1 == parts.height)
        for (std::uint32_t x = run.from; x < run.to; ++x) open_at(part, x, y);
      if (run.from == 0) open_at(part, 0, y);
      if (run.to == parts.width) open_at(part, parts.width - 1, y);
    });
  }

  const TileLayers& layers_;
  const char* zones_layer_;
  const TileZones& zones_;
  BorderZones borders_;
  std::vector<std::vector<std::uint8_t>> open_;  // by tile: of each part on its border: it reaches the image's end
  std::vector<std::uint8_t> joined_open_;
};

}  // namespace

void find_enclosed_ground(const TileLayers& layers, const char* zones_layer, const TileZones& zones,
                          const GroundOfGroups& chosen, const TileGroups& groups) {
  Enclosing enclosing(layers, zones_layer, zones);
  for_each_tile(layers.grid, [&](std::size_t tile) {
    const std::uint32_t ground = chosen.of_group[groups.of[tile]];
    if (ground != 0) {
      enclosing.find(tile, ground);
      return;
    }
    const TileFrame frame = tile_frame(layers.grid, tile);
    layers.write("mask", tile, filled_image(frame.width, frame.height, 0));
  });
  enclosing.join();
  for_each_tile(layers.grid, [&](std::size_t tile) { enclosing.decide(tile); });
}

}  // namespace ilot
