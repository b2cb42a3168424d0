// SPDX-License-Identifier: Apache-2.0
// Which tile of a quadtree shows what.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/box3.h"

namespace ilot {

struct TileItem {
  Box3<Vec3> box;
  std::uint32_t triangles = 0;
};

struct ModelTile {
  std::vector<std::uint32_t> items;     // that it shows itself, by size, the largest first
  std::vector<std::uint32_t> children;  // numbers of tiles, which show further items beside these
  Box3<Vec3> box;                       // of all items of it and its children
  double missing_m = 0;  // the size (diagonal of the box) of the largest item that only its children show
};

struct TileTreeParams {
  std::uint32_t most_triangles = 20000;  // of a tile, unless one item has more
  double widest_m = 16000;               // a wider tile shows nothing itself
};

// A tile shows the largest items of its square and leaves the others to its four quarters, each item to the one with
// its middle; so what is not shown from afar is small. Returns the tiles with the root first, each before its children;
// none for no items. Ties in size fall to the lower number. O(n log n) for each of its levels.
std::vector<ModelTile> tile_tree(const std::vector<TileItem>& items, const TileTreeParams& params = {});

}  // namespace ilot
