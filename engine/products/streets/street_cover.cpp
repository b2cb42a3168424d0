// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_cover.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "engine/products/streets/ground/standing_form.h"

namespace ilot {
namespace {

// The cover of the pixels of a tile.
std::vector<GroundCover> cover_of(const StreetTiles& tiles, std::size_t tile) {
  const Cells& cells = tiles.cells();
  const Image mask = layer_tile(tiles.layers(), "mask", tile), range = layer_tile(tiles.layers(), "range", tile),
              structures = layer_tile(cells.layers, "structure", tile);
  std::vector<GroundCover> cover(mask.size(), GroundCover::unseen);
  for (std::size_t i = 0; i < cover.size(); ++i) {
    const auto structure = static_cast<Structure>(structures.values[cells.cell_of(i, mask.width)]);
    if (structure == Structure::crown)
      cover[i] = GroundCover::crown;
    else if (range.values[i] == kNoHeight)
      continue;
    else if (mask.values[i] == 1)
      cover[i] = GroundCover::ground;
    else if (structure == Structure::wall || structure == Structure::roof)
      cover[i] = GroundCover::building;
  }
  return cover;
}

// The place in `count` pixels from `least` on, at `per_unit` pixels for each unit, of the middles of the pixels of a
// tile; -1 outside.
std::vector<std::int32_t> places(double from, double step, std::uint32_t side, double least, double per_unit,
                                 std::uint32_t count) {
  std::vector<std::int32_t> out(side, -1);
  for (std::uint32_t i = 0; i < side; ++i) {
    const double at = std::floor((from + (i + 0.5) * step - least) * per_unit);
    if (at >= 0 && at < count) out[i] = static_cast<std::int32_t>(at);
  }
  return out;
}

// Paints the part of an image that lies over a tile with this cover, whose box in the CRS is `box`.
void paint_over(std::span<const GroundCover> cover, std::uint32_t side, const FlatBox& box, CoverImage& image) {
  const double per_x = image.width / image.box.width(), per_y = image.height / image.box.height();
  const double step = box.width() / side;
  const auto columns = places(box.min.x, step, side, image.box.min.x, per_x, image.width);
  const auto rows = places(box.min.y, step, side, image.box.min.y, per_y, image.height);
  for (std::uint32_t v = 0; v < side; ++v) {
    if (rows[v] < 0) continue;
    GroundCover* out =
        image.pixels.data() + std::size_t{image.height - 1 - static_cast<std::uint32_t>(rows[v])} * image.width;
    const GroundCover* in = cover.data() + std::size_t{v} * side;
    for (std::uint32_t u = 0; u < side; ++u)
      if (columns[u] >= 0) out[columns[u]] = std::max(out[columns[u]], in[u]);
  }
}

FlatBox box_of(const TileRaster& raster, std::size_t tile) {
  const Index3 corner = raster.corner(tile);
  const auto at = [&](std::int64_t units) { return static_cast<double>(units) * raster.unit; };
  return {{at(corner.x), at(corner.y)}, {at(corner.x + raster.tile_units()), at(corner.y + raster.tile_units())}};
}

// Images have pixels in common with several tiles; the greatest cover wins, in any order.
void paint(const StreetTiles& tiles, std::span<CoverImage> images) {
  const TileRaster& raster = tiles.raster();
  std::vector<std::mutex> locks(images.size());
  for_each_tile(raster.grid, [&](std::size_t tile) {
    const FlatBox box = box_of(raster, tile);
    if (std::ranges::none_of(images, [&](const CoverImage& image) { return image.box.overlaps(box); })) return;
    const std::vector<GroundCover> cover = cover_of(tiles, tile);
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (!images[i].box.overlaps(box)) continue;
      const std::lock_guard lock(locks[i]);
      paint_over(cover, raster.grid.side, box, images[i]);
    }
  });
}

}  // namespace

CoverSource street_cover(const StreetTiles& tiles) {
  return {tiles.raster().scale.pixel, [&tiles](std::span<CoverImage> images) { paint(tiles, images); }};
}

}  // namespace ilot
