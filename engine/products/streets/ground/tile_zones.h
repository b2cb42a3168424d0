// SPDX-License-Identifier: Apache-2.0
// Inside of find_ground_tiled: the flat zones of a street that is too large to hold.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/tiles/tile_layers.h"
#include "kernels/morphology/border_zones.h"

namespace ilot {

struct GroundOfGroups {
  std::vector<std::uint32_t> of_group;         // number in the whole; 0 = no zone
  std::vector<std::uint64_t> taken, left_out;  // pixels; left out: at least a tenth of the largest, the largest first
};

// Whether outward_drops are counted, which ground() asks for.
enum class OutwardDrops : std::uint8_t { left_out, counted };

// Flat zones of tiles, joined where they touch. In order: find of all tiles, join, then the rest. Different tiles from
// several threads at once. Memory: 24 bytes a zone of a tile, 8 a pixel of their borders.
class TileZones {
 public:
  // Labels of tiles are kept in `layer`.
  TileZones(const TileLayers& layers, const char* layer);

  void find(std::size_t tile, const Image& image, Height lambda, OutwardDrops drops_wanted);
  void join(Height lambda);

  // The numbers in the whole of the labels of a tile; [0] = 0.
  std::vector<std::uint32_t> numbers_of(std::size_t tile) const;
  // Those of the pixels of a tile and around it, kNoHeight outside of the image; empty where there are not two.
  Image around(std::size_t tile, std::uint32_t halo) const;
  // The ground of each group of tiles, as ground_zone chooses it, where falls were counted.
  GroundOfGroups ground(const TileGroups& groups) const;

 private:
  struct Zone {
    std::uint64_t first = 0;  // pixel in the whole
    std::uint32_t pixels = 0;
    std::uint32_t on_border = 0;
    std::int32_t drops = 0;  // within the tile
  };
  struct Candidate {
    std::uint64_t first, pixels;
    std::int32_t drops;
    std::uint32_t group, number;
  };
  std::uint32_t number(std::size_t tile, std::size_t zone) const;
  // Empty where the tile is absent.
  std::vector<std::uint32_t> numbers_at(std::int64_t row, std::int64_t column) const;
  std::vector<Candidate> candidates(const TileGroups& groups) const;
  bool has_two_zones(std::int64_t from_column, std::int64_t to_column, std::int64_t from_row,
                     std::int64_t to_row) const;

  const TileLayers& layers_;
  const char* layer_;
  BorderZones borders_;
  std::vector<std::vector<Zone>> zones_;  // by tile, then label; [0] unused
  std::vector<std::uint32_t> first_;      // numbers given to zones of tiles before
};

}  // namespace ilot
