// SPDX-License-Identifier: Apache-2.0
#include "engine/run/street_labels.h"

#include <algorithm>

#include "engine/pass/pass.h"
#include "engine/run/lattice_cells.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 24;
constexpr std::size_t kTilesAtHand = 4;  // points come in Morton order: around a corner of tiles, in turn from these
constexpr std::uint64_t kBytesOfTiles = (kTilesAtHand * 2 + 1) << 20;
constexpr std::uint32_t kFacade = 0xffffffffu;

class Verdict {
 public:
  Verdict(const StreetTiles& tiles, const ThingLabels& things, double least_height)
      : tiles_(tiles),
        things_(things),
        least_(tiles.raster().scale.units(least_height)),
        x_(tiles.raster().x * tiles.raster().pixel),
        y_(tiles.raster().y * tiles.raster().pixel),
        side_(tiles.raster().grid.side),
        pixel_of_(tiles.raster().pixel) {}

  StreetLabel of(Index3 p) {
    const std::uint32_t x = pixel_of_(p.x - x_), y = pixel_of_(p.y - y_);
    const TileAtHand& tile = tile_with(x, y);
    const std::size_t pixel = std::size_t{y - tile.y} * side_ + x - tile.x;
    const Height level = tile.level.values[pixel];
    if (level == kNoHeight) return {};
    if (static_cast<Height>(p.z) - level < least_) return {0, PointLabel::ground};
    const auto thing = static_cast<std::uint32_t>(tile.things.values[pixel]);
    if (thing == kFacade) return {0, PointLabel::facade};
    return {things_.object[thing], things_.label[thing]};
  }

 private:
  struct TileAtHand {
    std::uint32_t x = 0, y = 0;     // of its first pixel
    Image level = {}, things = {};  // kFacade in things: where nothing stands and the mask has ended
    bool holds(std::uint32_t u, std::uint32_t v, std::uint32_t side) const {
      return level.size() > 0 && u - x < side && v - y < side;  // below x and y they wrap around
    }
  };

  // The one used last comes first.
  const TileAtHand& tile_with(std::uint32_t x, std::uint32_t y) {
    if (at_hand_[0].holds(x, y, side_)) return at_hand_[0];
    std::size_t i = 1;
    while (i + 1 < kTilesAtHand && !at_hand_[i].holds(x, y, side_)) ++i;
    if (!at_hand_[i].holds(x, y, side_)) at_hand_[i] = loaded(x / side_ * side_, y / side_ * side_);
    std::rotate(at_hand_, at_hand_ + i, at_hand_ + i + 1);
    return at_hand_[0];
  }

  TileAtHand loaded(std::uint32_t x, std::uint32_t y) const {
    const std::size_t tile = std::size_t{y / side_} * tiles_.raster().grid.columns() + x / side_;
    TileAtHand out{x, y, layer_tile(tiles_.layers(), "level", tile), layer_tile(tiles_.layers(), "things", tile)};
    const Image mask = layer_tile(tiles_.layers(), "mask", tile);
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (out.things.values[i] == 0 && mask.values[i] != 1) out.things.values[i] = static_cast<Height>(kFacade);
    return out;
  }

  const StreetTiles& tiles_;
  const ThingLabels& things_;
  Height least_;
  std::int64_t x_, y_;  // of the raster's corner, lattice units
  std::uint32_t side_;
  LatticeCells pixel_of_;
  TileAtHand at_hand_[kTilesAtHand];
};

}  // namespace

void write_street_labels(const Store& store, const StreetTiles& tiles, const ThingLabels& things, double least_height,
                         const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint + kBytesOfTiles, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto codes = store.read(block, columns::kCodes);
    Verdict verdict(tiles, things, least_height);
    std::vector<StreetLabel> labels(codes.size());
    for (std::size_t p = 0; p < codes.size(); ++p) {
      const Index3 at = index_of({store.blocks()[block].node.tile, codes[p]});
      if (!context.wanted || context.wanted(at)) labels[p] = verdict.of(at);
    }
    store.write(block, columns::kStreet, labels);
    context.advance(codes.size());
  });
}

}  // namespace ilot
