// SPDX-License-Identifier: Apache-2.0
// Inside of the raster kernels and of streets: zones of tiles joined where they touch over the borders. Only those that
// reach a border of their tile are kept; what a tile holds whole it can judge alone.
#pragma once
#include <vector>

#include "kernels/morphology/border_pixels.h"
#include "kernels/morphology/zone_runs.h"

namespace ilot {

class BorderZones {
 public:
  explicit BorderZones(const TileGrid& grid);

  // Of each zone of a tile (by its number there; [0] = 0) its number among those on the tile's border, from 1; 0 = not
  // on it. `image`: what the zones are of, for the step over the border; without it zones that touch are joined.
  // Different tiles from several threads at once.
  std::vector<std::uint32_t> record(std::size_t tile, const ZoneRuns& zones, const Image& image);
  std::vector<std::uint32_t> record(std::size_t tile, const ZoneRuns& zones);

  // Joins all that was told: neighbours of two tiles that differ by at most lambda. Memory: 8 bytes a pixel of all
  // borders, 4 a zone on one.
  void join(Height lambda, Adjacency adjacency);

  // Of zone `on_border` of a tile (from 1), from 0 to count() - 1.
  std::uint32_t number(std::size_t tile, std::uint32_t on_border) const {
    return numbers_[first_[tile] + on_border - 1];
  }
  std::uint32_t count() const { return count_; }

  // Of a number: steps over borders that fall from it by more than lambda, less those that rise (outward_drops).
  std::int32_t drops(std::uint32_t number) const { return drops_[number]; }

 private:
  std::vector<std::uint32_t> record(std::size_t tile, const ZoneRuns& zones, std::vector<Height> heights);

  struct TileRecord {
    std::vector<Height> heights;       // of the perimeter; empty: zones that touch are joined
    std::vector<std::uint32_t> zones;  // of the perimeter, numbers on the border; 0 = none
    std::uint32_t count = 0;
  };
  BorderPixels pixels_;
  std::vector<TileRecord> recorded_;
  std::vector<std::size_t> first_;      // of each tile in numbers_
  std::vector<std::uint32_t> numbers_;  // of the zones on borders, tile after tile
  std::vector<std::int32_t> drops_;     // of what was joined
  std::uint32_t count_ = 0;
};

}  // namespace ilot
