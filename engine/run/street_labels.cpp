// SPDX-License-Identifier: Apache-2.0
#include "engine/run/street_labels.h"

#include <algorithm>

#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 24;
constexpr std::size_t kTilesAtHand = 4;  // points come in Morton order: around a corner of tiles, in turn from these
constexpr std::uint64_t kBytesOfTiles = (kTilesAtHand * 2 + 1) << 20;
constexpr std::uint32_t kFacade = 0xffffffffu;

class Verdict {
 public:
  Verdict(const StreetTiles& tiles, const ThingLabels& things, double least_height)
      : tiles_(tiles), things_(things), least_(tiles.raster().scale.units(least_height)) {}

  StreetLabel of(Index3 p) {
    const StreetRaster& raster = tiles_.raster();
    const auto x = static_cast<std::uint32_t>(raster.column(p.x)), y = static_cast<std::uint32_t>(raster.row(p.y));
    const std::uint32_t side = raster.grid.side;
    const TileAtHand& tile = tile_at(std::size_t{y / side} * raster.grid.columns() + x / side);
    const std::size_t pixel = std::size_t{y % side} * side + x % side;
    const Height level = tile.level.values[pixel];
    if (level == kNoHeight) return {};
    if (static_cast<Height>(p.z) - level < least_) return {0, PointLabel::ground};
    const auto thing = static_cast<std::uint32_t>(tile.things.values[pixel]);
    if (thing == kFacade) return {0, PointLabel::facade};
    return {things_.object[thing], things_.label[thing]};
  }

 private:
  struct TileAtHand {
    std::size_t tile = static_cast<std::size_t>(-1);
    Image level = {}, things = {};  // kFacade in things: where nothing stands and the mask has ended
  };

  // The one used last comes first.
  const TileAtHand& tile_at(std::size_t tile) {
    if (at_hand_[0].tile == tile) return at_hand_[0];
    std::size_t i = 1;
    while (i + 1 < kTilesAtHand && at_hand_[i].tile != tile) ++i;
    if (at_hand_[i].tile != tile) at_hand_[i] = loaded(tile);
    std::rotate(at_hand_, at_hand_ + i, at_hand_ + i + 1);
    return at_hand_[0];
  }

  TileAtHand loaded(std::size_t tile) const {
    TileAtHand out{tile, layer_tile(tiles_.layers(), "level", tile), layer_tile(tiles_.layers(), "things", tile)};
    const Image mask = layer_tile(tiles_.layers(), "mask", tile);
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (out.things.values[i] == 0 && mask.values[i] != 1) out.things.values[i] = static_cast<Height>(kFacade);
    return out;
  }

  const StreetTiles& tiles_;
  const ThingLabels& things_;
  Height least_;
  TileAtHand at_hand_[kTilesAtHand];
};

}  // namespace

void write_street_labels(const Store& store, const StreetTiles& tiles, const ThingLabels& things, double least_height,
                         const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint + kBytesOfTiles, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto codes = store.read<std::uint64_t>(block, "codes");
    Verdict verdict(tiles, things, least_height);
    std::vector<StreetLabel> labels(codes.size());
    for (std::size_t p = 0; p < codes.size(); ++p) {
      const Index3 at = index_of({store.blocks()[block].node.tile, codes[p]});
      if (!context.wanted || context.wanted(at)) labels[p] = verdict.of(at);
    }
    store.write<StreetLabel>(block, "street", labels);
    context.advance(codes.size());
  });
}

}  // namespace ilot
