// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/tile_layers.h"

#include <algorithm>

namespace ilot {

std::int64_t tile_index(std::int64_t pixel, std::uint32_t side) {
  return pixel >= 0 ? pixel / side : (pixel - side + 1) / std::int64_t{side};
}

Image layer_tile(const TileLayers& layers, const char* layer, std::size_t tile) {
  const TileFrame frame = tile_frame(layers.grid, tile);
  Image out{frame.width, frame.height, std::vector<Height>(std::size_t{frame.width} * frame.height)};
  layers.read(layer, tile, {0, 0, frame.width, frame.height}, {out.values.data(), frame.width});
  return out;
}

Image layer_window(const TileLayers& layers, const char* layer, std::int64_t x, std::int64_t y, std::uint32_t width,
                   std::uint32_t height) {
  const TileGrid& grid = layers.grid;
  Image out = filled_image(width, height, kNoHeight);
  for (std::int64_t row = tile_index(y, grid.side); row <= tile_index(y + height - 1, grid.side); ++row) {
    for (std::int64_t column = tile_index(x, grid.side); column <= tile_index(x + width - 1, grid.side); ++column) {
      const std::size_t tile = grid.tile_at(row, column);
      if (tile == kNoTile) continue;
      const TileFrame frame = tile_frame(grid, tile);
      const std::int64_t x0 = std::max<std::int64_t>(x, frame.x), y0 = std::max<std::int64_t>(y, frame.y);
      const std::int64_t x1 = std::min<std::int64_t>(x + width, frame.x + frame.width);
      const std::int64_t y1 = std::min<std::int64_t>(y + height, frame.y + frame.height);
      layers.read(layer, tile,
                  {static_cast<std::uint32_t>(x0 - frame.x), static_cast<std::uint32_t>(y0 - frame.y),
                   static_cast<std::uint32_t>(x1 - x0), static_cast<std::uint32_t>(y1 - y0)},
                  {out.values.data() + (y0 - y) * std::int64_t{width} + (x0 - x), width});
    }
  }
  return out;
}

Image layer_around(const TileLayers& layers, const char* layer, std::size_t tile, std::uint32_t halo) {
  const TileFrame frame = tile_frame(layers.grid, tile);
  if (halo == 0) return layer_tile(layers, layer, tile);
  return layer_window(layers, layer, std::int64_t{frame.x} - halo, std::int64_t{frame.y} - halo, frame.width + 2 * halo,
                      frame.height + 2 * halo);
}

Image without_halo(const Image& image, std::uint32_t halo) {
  Image out = filled_image(image.width - 2 * halo, image.height - 2 * halo, 0);
  for (std::uint32_t y = 0; y < out.height; ++y)
    std::copy_n(image.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{y + halo} * image.width + halo),
                out.width, out.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * out.width));
  return out;
}

ReadTile reader_of(const TileLayers& layers, const char* layer) {
  return [&layers, layer](std::size_t tile) { return layer_tile(layers, layer, tile); };
}

ReadAround around_reader_of(const TileLayers& layers, const char* layer) {
  return [&layers, layer](std::size_t tile, std::uint32_t halo) { return layer_around(layers, layer, tile, halo); };
}

WriteTile writer_of(const TileLayers& layers, const char* layer) {
  return [&layers, layer](std::size_t tile, const Image& image) { layers.write(layer, tile, image); };
}

}  // namespace ilot
