// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/barred_holes.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace ilot {
namespace {

// Choice: as kBarShare in panes.cpp.
constexpr double kBarOfPane = 0.43;  // share of the narrower pane that a bar takes at most
// Derived: each end is known to a cell.
constexpr std::int64_t kEndsAlike = 2;  // cells between the ends of two panes of one window, at most
// Derived: as kCellsOfBar in panes.cpp.
constexpr double kCellsOfPier = 2;  // cells across the widest bar from which on panes beside each other are joined

struct Pane {
  CellRegion region;
  CellBox box;
  bool joined = false;
};

// The first and the last cell of a pane across a bar and along it.
struct Extent {
  std::int64_t low = 0, high = 0, from = 0, to = 0;
  std::int64_t size() const { return high - low + 1; }
};

Extent extent_of(const CellBox& b, bool upright_bar) {
  return upright_bar ? Extent{b.c0, b.c1, b.r0, b.r1} : Extent{b.r0, b.r1, b.c0, b.c1};
}

// Whether no more than a bar is between two panes, of which the first is to the left or below.
bool is_bar_between(const CellBox& first, const CellBox& second, bool upright_bar, double cell) {
  if (upright_bar && kCellsOfPier * cell > kWidestBar) return false;
  const Extent a = extent_of(first, upright_bar), b = extent_of(second, upright_bar);
  const std::int64_t gap = b.low - a.high - 1;
  const double widest =
      std::min(std::max(1.0, kWidestBar / cell), kBarOfPane * static_cast<double>(std::min(a.size(), b.size())));
  return gap >= 0 && static_cast<double>(gap) <= widest && std::abs(a.from - b.from) <= kEndsAlike &&
         std::abs(a.to - b.to) <= kEndsAlike;
}

// Adds the second pane to the first one, with the cells of the bar between them.
void join(Pane& a, Pane&& b, bool upright_bar, std::int64_t columns) {
  const Extent p = extent_of(a.box, upright_bar), q = extent_of(b.box, upright_bar);
  std::vector<std::uint32_t>& cells = a.region.cells;
  cells.insert(cells.end(), b.region.cells.begin(), b.region.cells.end());
  for (std::int64_t across = p.high + 1; across < q.low; ++across)
    for (std::int64_t along = std::max(p.from, q.from); along <= std::min(p.to, q.to); ++along)
      cells.push_back(static_cast<std::uint32_t>(upright_bar ? along * columns + across : across * columns + along));
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  a.box = {std::min(a.box.c0, b.box.c0), std::max(a.box.c1, b.box.c1), std::min(a.box.r0, b.box.r0),
           std::max(a.box.r1, b.box.r1)};
  a.joined = true;
}

// Joins the pane with the first other one that only a bar divides from it, and removes that one.
bool join_next(std::vector<Pane>& panes, std::size_t i, const WallCells& cells) {
  for (std::size_t k = 0; k < panes.size(); ++k)
    for (const bool upright : {true, false}) {
      if (k == i || !is_bar_between(panes[i].box, panes[k].box, upright, cells.cell)) continue;
      join(panes[i], std::move(panes[k]), upright, cells.columns);
      panes.erase(panes.begin() + static_cast<std::ptrdiff_t>(k));
      return true;
    }
  return false;
}

}  // namespace

std::vector<CellRegion> regions_over_bars(const std::vector<WallHole>& holes, const WallCells& cells) {
  std::vector<Pane> panes;
  for (const WallHole& hole : holes)
    if (hole.straight) panes.push_back({hole.region, hole.box});
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < panes.size() && !more; ++i) more = join_next(panes, i, cells);
  }
  std::vector<CellRegion> regions;
  for (Pane& pane : panes)
    if (pane.joined) regions.push_back(std::move(pane.region));
  return regions;
}

}  // namespace ilot
