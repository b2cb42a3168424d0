// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels and to streets. Zones of tiles are joined where they touch across the borders. Only
// zones that reach a border of their tile are kept, because a tile can judge its other zones alone.
#pragma once
#include <vector>

#include "kernels/morphology/border_pixels.h"
#include "kernels/morphology/zone_runs.h"

namespace ilot {

class BorderZones {
 public:
  explicit BorderZones(const TileGrid& grid);

  // Records the zones of a tile. Returns for each zone (by its number in the tile; [0] = 0) its number among the zones
  // on the border of the tile, from 1. The number is 0 when the zone is not on the border. `image` is the image of the
  // zones and gives the height steps across the border. Without it all zones that touch are joined. The function may be
  // called for different tiles from several threads at once.
  std::vector<std::uint32_t> record(std::size_t tile, const ZoneRuns& zones, const Image& image);
  std::vector<std::uint32_t> record(std::size_t tile, const ZoneRuns& zones);

  // Joins the recorded zones where neighbouring pixels of two tiles differ by at most lambda. Memory: 8 bytes per pixel
  // of all borders and 4 bytes per zone on a border.
  void join(Height lambda, Adjacency adjacency);

  // Returns the number of the joined zone, from 0 to count() - 1, of the zone `on_border` (from 1) of a tile.
  std::uint32_t number(std::size_t tile, std::uint32_t on_border) const {
    return numbers_[first_[tile] + on_border - 1];
  }
  std::uint32_t count() const { return count_; }

  // Outward drops of the joined zone over the borders of tiles: the number of steps down by more than lambda, less the
  // number of steps up (outward_drops).
  std::int32_t drops(std::uint32_t number) const { return drops_[number]; }

 private:
  std::vector<std::uint32_t> record(std::size_t tile, const ZoneRuns& zones, std::vector<Height> heights);

  struct TileRecord {
    std::vector<Height> heights;       // of the perimeter; empty: all zones that touch are joined
    std::vector<std::uint32_t> zones;  // of the perimeter, numbers on the border; 0 = no zone
    std::uint32_t count = 0;
  };
  BorderPixels pixels_;
  std::vector<TileRecord> recorded_;
  std::vector<std::size_t> first_;      // per tile: its first entry in numbers_
  std::vector<std::uint32_t> numbers_;  // of the zones on borders, tile after tile
  std::vector<std::int32_t> drops_;     // per joined zone
  std::uint32_t count_ = 0;
};

}  // namespace ilot
