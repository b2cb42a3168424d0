// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_labels.h"

#include <algorithm>

#include "engine/products/streets/ground/standing_form.h"
#include "engine/tiles/lattice_cells.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 24;
constexpr std::size_t kCachedTiles = 4;  // in Morton order, points around a common corner alternate between four tiles
constexpr std::uint64_t kBytesOfPixel = 16;  // of a cached tile: its layers, the mask while it is loaded
// Derived: a roof of 60 degrees falls by so much over the diagonal of a pixel. Steeper ones are walls.
constexpr double kFallOfRoof = 2.45;  // pixels
constexpr std::uint32_t kFacade = 0xffffffffu, kRoof = kFacade - 1;

// The label of what was taken out above a cell.
PointLabel label_above(Structure of_cell) {
  if (of_cell == Structure::crown) return PointLabel::vegetation;
  return of_cell == Structure::eaves ? PointLabel::roof : PointLabel::facade;
}

class Verdict {
 public:
  Verdict(const StreetTiles& tiles, const ObjectLabels& candidates, double least_height)
      : tiles_(tiles),
        candidates_(candidates),
        least_(tiles.raster().scale.units(least_height)),
        clearance_(tiles.raster().scale.units(kClearance)),
        fall_(tiles.raster().scale.units(kFallOfRoof * tiles.raster().scale.pixel)),
        side_(tiles.raster().grid.side),
        units_(tiles.raster().tile_units()),
        pixel_of_(tiles.raster().pixel) {}

  StreetLabel of(Index3 p) {
    const CachedTile& tile = tile_over(p);
    const std::size_t pixel = std::size_t{pixel_of_(p.y - tile.y)} * side_ + pixel_of_(p.x - tile.x);
    const Height level = tile.level.values[pixel];
    if (level == kNoHeight) return {};
    const Height above = height_of(p.z) - level;
    if (above < least_) return {0, PointLabel::ground};
    const auto candidate = static_cast<std::uint32_t>(tile.candidates.values[pixel]);
    const auto structure = static_cast<Structure>(tile.structure.values[tiles_.cells().cell_of(pixel, side_)]);
    if (is_taken_out(structure, above, clearance_)) return {0, label_above(structure)};
    // What is farther below the highest point of a pixel than a roof falls is the wall below it.
    const bool on_top = above >= clearance_ && height_of(p.z) >= tile.range.values[pixel] - fall_;
    if (candidate == kRoof) return {0, on_top ? PointLabel::roof : PointLabel::facade};
    if (candidate == kFacade) return {0, PointLabel::facade};
    const PointLabel label = candidates_.label[candidate];
    if (is_overhang(structure) && label == PointLabel::none) return {0, PointLabel::facade};
    if (above * tiles_.raster().scale.unit > candidates_.top[candidate]) return {0, PointLabel::vegetation};
    return {candidates_.object[candidate], label};
  }

 private:
  struct CachedTile {
    std::int64_t x = 0, y = 0;          // lattice units; its first pixel
    Image level = {}, candidates = {};  // kFacade, kRoof in candidates: no candidate, outside of the mask
    Image range = {};                   // highest z of pixels
    Image structure = {};               // of cells
    bool contains(Index3 p, std::int64_t units) const {
      return level.size() > 0 && p.x >= x && p.y >= y && p.x - x < units && p.y - y < units;
    }
  };

  // The tile that was used last is moved to the front.
  const CachedTile& tile_over(Index3 p) {
    if (cached_[0].contains(p, units_)) return cached_[0];
    std::size_t i = 1;
    while (i + 1 < kCachedTiles && !cached_[i].contains(p, units_)) ++i;
    if (!cached_[i].contains(p, units_)) {
      cached_[i] = {};  // before the next is loaded: there are never more than kCachedTiles
      cached_[i] = loaded(tiles_.raster().tile_over(p));
    }
    std::rotate(cached_, cached_ + i, cached_ + i + 1);
    return cached_[0];
  }

  CachedTile loaded(std::size_t tile) const {
    const Index3 corner = tiles_.raster().corner(tile);
    CachedTile out{corner.x,
                   corner.y,
                   layer_tile(tiles_.layers(), "level", tile),
                   layer_tile(tiles_.layers(), "candidates", tile),
                   layer_tile(tiles_.layers(), "range", tile),
                   layer_tile(tiles_.cells().layers, "structure", tile)};
    const Image mask = layer_tile(tiles_.layers(), "mask", tile);
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (out.candidates.values[i] == 0 && mask.values[i] != 1) {
        const bool roof =
            out.structure.values[tiles_.cells().cell_of(i, side_)] == static_cast<Height>(Structure::roof);
        out.candidates.values[i] = static_cast<Height>(roof ? kRoof : kFacade);
      }
    return out;
  }

  const StreetTiles& tiles_;
  const ObjectLabels& candidates_;
  Height least_, clearance_, fall_;
  std::uint32_t side_;
  std::int64_t units_;  // side of a tile in lattice units
  LatticeCells pixel_of_;
  CachedTile cached_[kCachedTiles];
};

}  // namespace

void write_street_labels(const Store& store, const StreetTiles& tiles, const ObjectLabels& candidates,
                         double least_height, const PassContext& context) {
  const std::uint64_t side = tiles.raster().grid.side, of_tiles = kCachedTiles * side * side * kBytesOfPixel;
  std::vector<std::uint64_t> bytes;
  for (const Block& b : store.blocks()) bytes.push_back(b.points * kBytesPerPoint + of_tiles);
  run_tasks(tiles.raster().grid, bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto codes = store.read(block, columns::kCodes);
    Verdict verdict(tiles, candidates, least_height);
    std::vector<StreetLabel> labels(codes.size());
    for (std::size_t p = 0; p < codes.size(); ++p) {
      const Index3 at = index_of({store.blocks()[block].node.tile, codes[p]});
      if (!context.wanted || context.wanted(at)) labels[p] = verdict.of(at);
    }
    store.write(block, columns::kStreet, labels);
    context.advance(codes.size());
  });
}

ProductLabels street_labels() {
  ProductLabels labels = product_labels<StreetLabel>(
      [](const Store& store, std::uint32_t block) { return store.read(block, columns::kStreet); }, columns::kStreetRows,
      [](const StreetLabel& l) {
        return PointClass{l.label, l.label != PointLabel::none, l.object != 0};
      },
      {label_field<StreetLabel>(FieldPlace::object, "object_id", "on the street, 0 = none",
                                [](const StreetLabel& l) { return l.object; })});
  labels.gives_classes = true;
  return labels;
}

}  // namespace ilot
