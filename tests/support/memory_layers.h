// SPDX-License-Identifier: Apache-2.0
// Layers of a street in memory, and their conversion into one image.
#pragma once
#include <map>
#include <mutex>
#include <string>

#include "engine/tiles/tile_layers.h"
#include "tests/support/image_tiles.h"

namespace ilot::test {

class MemoryLayers {
 public:
  explicit MemoryLayers(const TileGrid& grid) {
    layers.grid = grid;
    layers.read = [this](const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) {
      const std::lock_guard lock(mutex_);
      const Image& whole = tiles_.at({layer, tile});
      for (std::uint32_t y = 0; y < part.height; ++y)
        for (std::uint32_t x = 0; x < part.width; ++x)
          out.first[y * out.stride + x] = whole.values[std::size_t{part.y + y} * whole.width + part.x + x];
    };
    layers.write = [this](const char* layer, std::size_t tile, const Image& image) {
      const std::lock_guard lock(mutex_);
      tiles_[{layer, tile}] = image;
    };
    layers.drop = [](const char*) {};
  }

  void put(const char* layer, const Image& image) {
    for (std::size_t t = 0; t < layers.grid.count(); ++t) layers.write(layer, t, tiles_of(image, layers.grid)(t));
  }
  Image whole(const char* layer) const {
    Image out = filled_image(layers.grid.width, layers.grid.height, 0);
    for (std::size_t t = 0; t < layers.grid.count(); ++t) into(out, layers.grid)(t, layer_tile(layers, layer, t));
    return out;
  }

  TileLayers layers;

 private:
  mutable std::mutex mutex_;
  std::map<std::pair<std::string, std::size_t>, Image> tiles_;
};

}  // namespace ilot::test
