// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/tiled_ground.h"

#include <algorithm>

#include "engine/products/streets/ground/tile_zones.h"
#include "kernels/morphology/fill.h"
#include "kernels/morphology/fill_missing_tiled.h"
#include "kernels/morphology/link_regions_tiled.h"

namespace ilot {
namespace {

constexpr const char* kZones = "zones";

using Links = std::vector<std::vector<LinkPixel>>;  // by tile

// Draws the links of all tiles that a rectangle of the whole image touches.
void draw_links(const TileGrid& grid, const Links& links, std::int64_t x, std::int64_t y, Image& part) {
  const std::int64_t side = grid.side;
  for (std::int64_t row = std::max<std::int64_t>(0, y / side); row * side < y + part.height; ++row)
    for (std::int64_t column = std::max<std::int64_t>(0, x / side); column * side < x + part.width; ++column) {
      const std::size_t tile = grid.tile_at(row, column);
      if (tile == kNoTile) continue;
      for (const LinkPixel& p : links[tile]) {
        const std::int64_t u = static_cast<std::int64_t>(p.pixel % grid.width) - x,
                           v = static_cast<std::int64_t>(p.pixel / grid.width) - y;
        if (u < 0 || v < 0 || u >= part.width || v >= part.height) continue;
        Height& height = part.values[static_cast<std::size_t>(v * part.width + u)];
        if (height == kNoHeight) height = p.height;
      }
    }
}

// Computes the flat zones of "filled" from "range" in two rounds: first gaps and holes are filled, then links and the
// holes that they close.
class GroundFilling {
 public:
  GroundFilling(const TileLayers& layers, const RasterScale& scale, const GroundParams& params)
      : layers_(layers),
        flat_(scale.units(params.flat)),
        gaps_{scale.pixels(params.longest_gap), scale.units(params.gap_step)},
        longest_link_(scale.pixels(params.longest_link)) {}

  void run() {
    const std::uint32_t halo = gaps_.longest + 2;
    const auto closed = [&](std::size_t tile) {
      return without_halo(fill_short_gaps(layer_around(layers_, "range", tile, halo), gaps_), halo - 1);
    };
    fill(closed, halo, "closed");
    const Links links = links_of(zones_of("closed"));
    const auto linked = [&](std::size_t tile) {
      const TileFrame frame = tile_frame(layers_.grid, tile);
      Image around = layer_around(layers_, "closed", tile, 1);
      draw_links(layers_.grid, links, std::int64_t{frame.x} - 1, std::int64_t{frame.y} - 1, around);
      return around;
    };
    fill(linked, 1, "filled");
    layers_.drop("closed");
    layers_.drop(kZones);
  }

 private:
  Links links_of(const TileZones& zones) const {
    return links_tiled(layers_.grid, {flat_, longest_link_}, around_reader_of(layers_, "closed"),
                       [&](std::size_t tile, std::uint32_t halo) { return zones.around(tile, halo); });
  }

  // Fills the missing pixels of tiles and writes them to a layer. `read` gives a tile with one pixel around it.
  void fill(const ReadTile& read, std::uint32_t halo, const char* layer) const {
    TiledMissing missing(layers_.grid);
    for_each_tile(layers_.grid, [&](std::size_t tile) { layers_.write(layer, tile, missing.fill(tile, read(tile))); },
                  {40, halo});
    missing.join();
    for_each_tile(layers_.grid, [&](std::size_t tile) {
      Image image = layer_tile(layers_, layer, tile);
      if (missing.finish(tile, image)) layers_.write(layer, tile, image);
    });
  }

  TileZones zones_of(const char* layer) const {
    TileZones zones(layers_, kZones);
    for_each_tile(layers_.grid, [&](std::size_t tile) { zones.find(tile, layer_tile(layers_, layer, tile), flat_); });
    zones.join(flat_);
    return zones;
  }

  const TileLayers& layers_;
  Height flat_;
  ShortGapsParams gaps_;
  std::uint32_t longest_link_;
};

}  // namespace

void fill_ground_tiled(const TileLayers& layers, const RasterScale& scale, const GroundParams& params) {
  GroundFilling(layers, scale, params).run();
}

}  // namespace ilot
