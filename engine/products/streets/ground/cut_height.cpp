// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/cut_height.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace ilot {
namespace {

// Choice: what is lower lies on the ground, as kerbs and plants do.
constexpr double kStanding = 0.5;  // metres above the terrain
// Choice: a few points above the cut, as strays or where the terrain is too low, do not count.
constexpr double kShare = 0.99;  // of the cells in which something stands

}  // namespace

double height_share(const Cells& cells, double storey) {
  const Height least = cells.scale.units(kStanding), most = cells.scale.units(storey);
  std::map<Height, std::uint64_t> standing;  // number of cells by height; all that is higher than a storey as one
  std::mutex mutex;
  for_each_tile(cells.layers.grid, [&](std::size_t tile) {
    const Image highest = layer_tile(cells.layers, "highest", tile),
                terrain = layer_tile(cells.layers, "terrain", tile);
    std::map<Height, std::uint64_t> own;
    for (std::size_t i = 0; i < highest.size(); ++i) {
      if (highest.values[i] == kNoHeight || terrain.values[i] == kNoHeight) continue;
      const Height above = highest.values[i] - terrain.values[i];
      if (above >= least) ++own[std::min(above, most)];
    }
    const std::lock_guard lock(mutex);
    for (const auto& [height, n] : own) standing[height] += n;
  });
  std::uint64_t all = 0, below = 0;
  for (const auto& [height, n] : standing) all += n;
  for (const auto& [height, n] : standing) {
    below += n;
    if (static_cast<double>(below) >= kShare * static_cast<double>(all))
      return static_cast<double>(height) / static_cast<double>(most);
  }
  return 1;
}

}  // namespace ilot
