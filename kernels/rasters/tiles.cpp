// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/tiles.h"

#include "kernels/core/parallel.h"
#include "kernels/core/union_find.h"

namespace ilot {

void run_tasks(const TileGrid& grid, std::span<const std::uint64_t> bytes,
               const std::function<void(std::size_t)>& body) {
  if (grid.run)
    grid.run(bytes, body);
  else
    parallel_for(bytes.size(), body);
}

void need_bytes(const TileGrid& grid, std::uint64_t bytes) {
  if (grid.need) grid.need(bytes);
}

void for_each_tile(const TileGrid& grid, const std::function<void(std::size_t)>& body, const TileCost& cost) {
  const std::uint64_t side = std::uint64_t{grid.side} + 2ull * cost.halo;
  const std::vector<std::uint64_t> bytes(grid.count(), side * side * cost.bytes);
  run_tasks(grid, bytes, body);
}

TileGroups groups_of(const TileGrid& grid) {
  std::vector<std::uint32_t> parents(grid.count());
  UnionFind sets(parents);
  for (std::uint32_t tile = 0; tile < parents.size(); ++tile) {
    const TilePlace at = grid.place(tile);
    for (const auto& [row, column] : {std::pair{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}}) {
      const std::size_t other = grid.tile_at(std::int64_t{at.row} + row, std::int64_t{at.column} + column);
      if (other != kNoTile) sets.unite(tile, static_cast<std::uint32_t>(other));
    }
  }
  TileGroups groups{0, std::vector<std::uint32_t>(grid.count(), 0)};
  for (std::uint32_t tile = 0; tile < groups.of.size(); ++tile) {  // a root is the first of its set
    const std::uint32_t root = sets.find(tile);
    groups.of[tile] = root == tile ? ++groups.count : groups.of[root];
  }
  return groups;
}

}  // namespace ilot
