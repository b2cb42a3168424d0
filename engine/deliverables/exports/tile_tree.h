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
  std::uint32_t level = 0, x = 0, y = 0;  // the square: 2^level of them along each side of the tree's
  std::vector<std::uint32_t> items;       // that it shows itself, by size, the largest first
  std::vector<std::uint32_t> children;    // numbers of tiles, which show further items beside these
  Box3<Vec3> box;                         // of all items of it and its children
  double missing_m = 0;  // the size (diagonal of the box) of the largest item that only its children show
};

struct ModelTree {
  std::vector<ModelTile> tiles;    // the root first, each before its children; none for no items
  double x = 0, y = 0, width = 0;  // the square of the root, which holds all items: its lower left corner
};

// Derived: vertices are float32 within 16 km, which rounds them by less than a millimetre.
constexpr double kVertexRounding = 1e-3;

struct TileTreeParams {
  std::uint32_t most_triangles = 20000;  // of a tile, unless one item has more
  double widest_m = 16000;               // a wider tile shows nothing itself
};

// A tile shows the largest items of its square and leaves the others to its four quarters, each item to the one with
// its middle; so what is not shown from afar is small, and an item may reach beyond the square by half its size.
// Children are in the order of x, then y. Ties in size fall to the lower number. O(n log n) for each of its levels.
ModelTree tile_tree(const std::vector<TileItem>& items, const TileTreeParams& params = {});

}  // namespace ilot
