// SPDX-License-Identifier: Apache-2.0
// The images of a street, tile by tile: what the tiled steps read and write.
#pragma once
#include <functional>

#include "kernels/rasters/tiles.h"

namespace ilot {

// Where a rectangle of pixels goes: rows `stride` apart.
struct PixelRows {
  Height* first = nullptr;
  std::size_t stride = 0;
};

// Layers by name, kept by the caller; called from several threads at once, for different tiles when writing. All layers
// are images of whole tiles; masks are 0 and 1, labels are numbers as heights.
struct TileLayers {
  TileGrid grid;
  // part: within the tile
  std::function<void(const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out)> read;
  std::function<void(const char* layer, std::size_t tile, const Image& image)> write;
  std::function<void(const char* layer)> drop;  // not while others read it
};

// A whole tile of a layer.
Image layer_tile(const TileLayers& layers, const char* layer, std::size_t tile);

// A rectangle of the whole; kNoHeight outside of the image. The corner may lie anywhere.
Image layer_window(const TileLayers& layers, const char* layer, std::int64_t x, std::int64_t y, std::uint32_t width,
                   std::uint32_t height);

// A tile and so many pixels on all sides.
Image layer_around(const TileLayers& layers, const char* layer, std::size_t tile, std::uint32_t halo);

// Without so many pixels on all sides.
Image without_halo(const Image& image, std::uint32_t halo);

// The access that kernels ask for.
ReadTile reader_of(const TileLayers& layers, const char* layer);
ReadAround around_reader_of(const TileLayers& layers, const char* layer);
WriteTile writer_of(const TileLayers& layers, const char* layer);

}  // namespace ilot
