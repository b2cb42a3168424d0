// SPDX-License-Identifier: Apache-2.0
// Internal to find_ground_tiled: the flat zones of a street that is too large for the memory.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/tiles/tile_layers.h"
#include "kernels/morphology/border_zones.h"

namespace ilot {

// The flat zones of tiles, joined where they touch. The order of calls is: find() for all tiles, then join(), then the
// rest. Several threads may work on different tiles at once. Memory: 24 bytes per zone of a tile and 8 bytes per pixel
// of the tile borders.
class TileZones {
 public:
  // The labels of the tiles are stored in `layer`.
  TileZones(const TileLayers& layers, const char* layer);

  void find(std::size_t tile, const Image& image, Height lambda);
  void join(Height lambda);

  // For each label of a tile, the number of its zone in the whole image; [0] = 0.
  std::vector<std::uint32_t> numbers_of(std::size_t tile) const;
  // The zone number of each pixel of a tile and of the halo around it; kNoHeight outside of the image. The image is
  // empty where it would contain fewer than two zones.
  Image around(std::size_t tile, std::uint32_t halo) const;

 private:
  struct Zone {
    std::uint32_t on_border = 0;
  };
  std::uint32_t number(std::size_t tile, std::size_t zone) const;
  // The result is empty where the tile is absent.
  std::vector<std::uint32_t> numbers_at(std::int64_t row, std::int64_t column) const;
  bool has_two_zones(std::int64_t from_column, std::int64_t to_column, std::int64_t from_row,
                     std::int64_t to_row) const;

  const TileLayers& layers_;
  const char* layer_;
  BorderZones borders_;
  std::vector<std::vector<Zone>> zones_;  // by tile, then label; [0] unused
  std::vector<std::uint32_t> first_;      // by tile: the number from which its inner zones are counted
};

}  // namespace ilot
