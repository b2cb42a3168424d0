// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/tiles.h"

#include "kernels/core/parallel.h"

namespace ilot {

void run_tasks(const TileGrid& grid, std::span<const std::uint64_t> bytes,
               const std::function<void(std::size_t)>& body) {
  if (grid.run)
    grid.run(bytes, body);
  else
    parallel_for(bytes.size(), body);
}

void for_each_tile(const TileGrid& grid, const std::function<void(std::size_t)>& body, const TileCost& cost) {
  std::vector<std::size_t> tiles;
  for (std::size_t tile = 0; tile < grid.count(); ++tile)
    if (grid.has(tile)) tiles.push_back(tile);
  const std::uint64_t side = std::uint64_t{grid.side} + 2ull * cost.halo;
  const std::vector<std::uint64_t> bytes(tiles.size(), side * side * cost.bytes);
  run_tasks(grid, bytes, [&](std::size_t i) { body(tiles[i]); });
}

}  // namespace ilot
