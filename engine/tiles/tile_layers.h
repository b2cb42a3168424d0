// SPDX-License-Identifier: Apache-2.0
// Access to the images of a street, tile by tile, which the tiled steps read and write.
#pragma once
#include <functional>

#include "kernels/rasters/tiles.h"

namespace ilot {

// The destination of a rectangle of pixels: rows that are `stride` apart.
struct PixelRows {
  Height* first = nullptr;
  std::size_t stride = 0;
};

// Layers by name, owned by the caller. The functions are called from several threads at once; writes are for different
// tiles. All layers are images of whole tiles. Masks are 0 and 1, labels are numbers stored as heights.
struct TileLayers {
  TileGrid grid;
  // `part` lies within the tile.
  std::function<void(const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out)> read;
  std::function<void(const char* layer, std::size_t tile, const Image& image)> write;
  std::function<void(const char* layer)> drop;  // must not be called while other threads read the layer
};

// The row or column of the tile with this row or column of pixels, which may lie outside of the image.
std::int64_t tile_index(std::int64_t pixel, std::uint32_t side);

// A whole tile of a layer.
Image layer_tile(const TileLayers& layers, const char* layer, std::size_t tile);

// A rectangle of the whole image; kNoHeight outside of the image. The corner may be anywhere.
Image layer_window(const TileLayers& layers, const char* layer, std::int64_t x, std::int64_t y, std::uint32_t width,
                   std::uint32_t height);

// A tile with `halo` pixels on all sides.
Image layer_around(const TileLayers& layers, const char* layer, std::size_t tile, std::uint32_t halo);

// The image without `halo` pixels on all sides.
Image without_halo(const Image& image, std::uint32_t halo);

// Access functions in the form that the kernels use.
ReadTile reader_of(const TileLayers& layers, const char* layer);
ReadAround around_reader_of(const TileLayers& layers, const char* layer);
WriteTile writer_of(const TileLayers& layers, const char* layer);

}  // namespace ilot
