// SPDX-License-Identifier: Apache-2.0
#include "engine/store/strays.h"

#include <algorithm>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

constexpr std::uint64_t kRestOverStrays = 10;  // strays are at most a tenth of the points from which they are far

// An occupied cell and the box that represents its points.
struct Occupied {
  CoarseCell cell;
  IndexBox box;
  bool many = false;
  std::uint64_t points = 0, places = 0;
};

IndexBox box_of(const CoarseCell& cell, const CellContent& content, int bits) {
  const std::int64_t edge = std::int64_t{1} << bits;
  const Index3 min{cell.x * edge, cell.y * edge, cell.z * edge};
  if (content.many) return {min, {min.x + edge - 1, min.y + edge - 1, min.z + edge - 1}};
  IndexBox box{content.places.front(), content.places.front()};
  for (const Index3& p : content.places) {
    box.add(p);
  }
  return box;
}

std::vector<Occupied> occupied(const CoarseCells& cells) {
  std::vector<Occupied> all;
  for (const auto& [cell, content] : cells.cells())
    all.push_back({cell, box_of(cell, content, cells.bits()), content.many, content.points, content.places.size()});
  return all;
}

// Calls visit(j) for each cell that a gap of one edge may join to cell i.
template <class Visit>
void for_each_near(const std::vector<Occupied>& all, std::size_t i, std::int64_t edge, const Visit& visit) {
  constexpr std::int64_t kReach = 2;  // a gap of one edge contains at most one cell
  const CoarseCell c = all[i].cell;
  const auto before = [](const Occupied& o, const CoarseCell& cell) { return o.cell < cell; };
  for (std::int64_t x = c.x - kReach; x <= c.x + kReach; ++x) {
    for (std::int64_t y = c.y - kReach; y <= c.y + kReach; ++y) {
      auto at = std::lower_bound(all.begin(), all.end(), CoarseCell{x, y, c.z - kReach}, before);
      for (; at != all.end() && at->cell <= CoarseCell{x, y, c.z + kReach}; ++at)
        if (all[i].box.grown(edge).intersects(at->box)) visit(static_cast<std::size_t>(at - all.begin()));
    }
  }
}

// Groups of the cells with few places; groups near a cell of many places are not candidates.
struct Groups {
  std::vector<std::uint32_t> of_cell;  // index of the first cell of its group
  std::vector<std::uint64_t> places;   // by first cell
  std::vector<bool> near_many;         // by first cell
};

Groups group(const std::vector<Occupied>& all, std::int64_t edge) {
  Groups g{std::vector<std::uint32_t>(all.size()), std::vector<std::uint64_t>(all.size()),
           std::vector<bool>(all.size())};
  UnionFind sets(g.of_cell);
  std::vector<bool> beside(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].many) continue;
    for_each_near(all, i, edge, [&](std::size_t j) {
      if (all[j].many) beside[i] = true;
      if (!all[j].many) sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    });
  }
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const std::uint32_t first = sets.find(i);
    g.places[first] += all[i].places;
    if (beside[i]) g.near_many[first] = true;
  }
  for (std::uint32_t i = 0; i < all.size(); ++i) g.of_cell[i] = sets.find(i);
  return g;
}

}  // namespace

Strays::Strays(int bits, std::vector<CoarseCell> cells) : bits_(bits), cells_(std::move(cells)) {
  if (bits_ >= kTileBits) return;
  const std::int64_t edge = std::int64_t{1} << bits_;
  for (const CoarseCell& c : cells_) {
    const PointKey first = key_of({c.x * edge, c.y * edge, c.z * edge});
    ranges_[first.tile].push_back({first.code, first.code + (std::uint64_t{1} << 3 * bits_) - 1});
  }
  for (auto& [tile, ranges] : ranges_)
    std::sort(ranges.begin(), ranges.end(), [](CodeRange a, CodeRange b) { return a.first < b.first; });
}

bool Strays::contains(Index3 p) const {
  return std::binary_search(cells_.begin(), cells_.end(), coarse_cell(p, bits_));
}

std::vector<CodeRange> Strays::in_tile(Tile tile) const {
  if (bits_ < kTileBits) {
    const auto found = ranges_.find(tile);
    return found == ranges_.end() ? std::vector<CodeRange>{} : found->second;
  }
  if (!contains(corner(tile))) return {};
  return {{0, UINT64_MAX}};
}

Strays find_strays(const CoarseCells& cells) {
  const std::vector<Occupied> all = occupied(cells);
  const Groups groups = group(all, cells.edge());
  std::uint64_t rest = 0, largest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].many) rest += all[i].points;
    largest = std::max(largest, groups.places[i]);
  }
  if (rest == 0) rest = largest;
  std::vector<CoarseCell> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint32_t g = groups.of_cell[i];
    const std::uint64_t places = groups.places[g];
    if (all[i].many || groups.near_many[g] || places >= kFewPlaces || kRestOverStrays * places > rest) continue;
    found.push_back(all[i].cell);
  }
  return {cells.bits(), std::move(found)};
}

Index3 least_corner(const CoarseCells& cells, const Strays& strays) {
  constexpr std::int64_t kFar = std::int64_t{1} << 52;
  Index3 least{kFar, kFar, kFar};
  for (const auto& [cell, content] : cells.cells()) {
    const Index3 at{cell.x * cells.edge(), cell.y * cells.edge(), cell.z * cells.edge()};
    if (!strays.contains(at)) least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
  }
  return cells.cells().empty() ? Index3{} : least;
}

}  // namespace ilot
