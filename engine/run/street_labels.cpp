// SPDX-License-Identifier: Apache-2.0
#include "engine/run/street_labels.h"

#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 24;
constexpr std::uint64_t kBytesOfTile = 4u << 20;

// One tile at a time: points come in Morton order, so tiles seldom change.
class Verdict {
 public:
  Verdict(const StreetTiles& tiles, const ThingLabels& things, double least_height)
      : tiles_(tiles), things_(things), least_(tiles.raster().scale.units(least_height)) {}

  StreetLabel of(Index3 p) {
    const StreetRaster& raster = tiles_.raster();
    const std::int64_t x = raster.column(p.x), y = raster.row(p.y), side = raster.grid.side;
    const auto tile = static_cast<std::size_t>(y / side * raster.grid.columns() + x / side);
    if (tile != tile_) load(tile);
    const auto pixel = static_cast<std::size_t>(y % side * side + x % side);
    const Height level = level_.values[pixel];
    if (level == kNoHeight) return {};
    if (static_cast<Height>(p.z) - level < least_) return {0, PointLabel::ground};
    const auto thing = static_cast<std::size_t>(labels_.values[pixel]);
    if (thing != 0) return {things_.object[thing], things_.label[thing]};
    if (mask_.values[pixel] != 1) return {0, PointLabel::facade};
    return {};
  }

 private:
  void load(std::size_t tile) {
    tile_ = tile;
    level_ = layer_tile(tiles_.layers(), "level", tile);
    mask_ = layer_tile(tiles_.layers(), "mask", tile);
    labels_ = layer_tile(tiles_.layers(), "things", tile);
  }
  const StreetTiles& tiles_;
  const ThingLabels& things_;
  Height least_;
  std::size_t tile_ = static_cast<std::size_t>(-1);
  Image level_, mask_, labels_;
};

}  // namespace

void write_street_labels(const Store& store, const StreetTiles& tiles, const ThingLabels& things, double least_height,
                         const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint + kBytesOfTile, b.points});
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
