// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tile_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot {
namespace {

// A quarter that holds what it holds at this width already has items at one place. Derived: below float32's rounding.
constexpr double kNarrowest = 1e-3;  // metres

struct Square {
  double x = 0, y = 0, width = 0;  // lower left corner
};

struct Work {
  const std::vector<TileItem>& items;
  const TileTreeParams& params;
  std::vector<ModelTile> tiles;
};

Vec3 middle(const Box3<Vec3>& box) {
  return 0.5 * (box.min + box.max);
}

double size_of(const TileItem& item) {
  return norm(item.box.max - item.box.min);
}

// Returns how many of the items, which are sorted, the tile shows itself.
std::size_t shown(const Work& work, const std::vector<std::uint32_t>& items, const Square& square) {
  if (square.width > work.params.widest_m) return 0;
  std::size_t count = 0, triangles = 0;
  for (; count < items.size(); ++count) {
    triangles += work.items[items[count]].triangles;
    if (count > 0 && triangles > work.params.most_triangles && square.width > kNarrowest) break;
  }
  return count;
}

std::uint32_t add_tile(Work& work, const std::vector<std::uint32_t>& items, const Square& square) {
  const auto number = static_cast<std::uint32_t>(work.tiles.size());
  work.tiles.emplace_back();
  const std::size_t own = shown(work, items, square);
  ModelTile tile;
  tile.box = work.items[items[0]].box;
  for (const std::uint32_t i : items) tile.box.add_box(work.items[i].box);
  tile.items.assign(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(own));
  if (own < items.size()) tile.missing_m = size_of(work.items[items[own]]);
  const double half = square.width / 2;
  std::array<std::vector<std::uint32_t>, 4> quarters;
  for (std::size_t k = own; k < items.size(); ++k) {
    const Vec3 at = middle(work.items[items[k]].box);
    quarters[(at.x >= square.x + half ? 1u : 0u) + (at.y >= square.y + half ? 2u : 0u)].push_back(items[k]);
  }
  for (std::size_t q = 0; q < quarters.size(); ++q)
    if (!quarters[q].empty())
      tile.children.push_back(
          add_tile(work, quarters[q], {square.x + (q & 1 ? half : 0), square.y + (q & 2 ? half : 0), half}));
  work.tiles[number] = std::move(tile);
  return number;
}

}  // namespace

std::vector<ModelTile> tile_tree(const std::vector<TileItem>& items, const TileTreeParams& params) {
  Work work{items, params, {}};
  if (items.empty()) return {};
  std::vector<std::uint32_t> order(items.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return size_of(items[a]) > size_of(items[b]); });
  Vec3 low = middle(items[0].box), high = low;
  for (const TileItem& item : items) {
    const Vec3 at = middle(item.box);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), 0};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), 0};
  }
  add_tile(work, order, {low.x, low.y, std::max(high.x - low.x, high.y - low.y)});
  return std::move(work.tiles);
}

}  // namespace ilot
