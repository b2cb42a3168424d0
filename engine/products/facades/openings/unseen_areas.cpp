// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/unseen_areas.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

// Derived: cells have four points, so 64 are expected in such a square; where a wall is nine times as sparse, seven,
// and none is there by chance once in a thousand.
constexpr std::int64_t kLeastSide = 4;  // cells along the side of a square in which nothing was seen

using enum WallCells::What;

bool in_opening(const std::vector<FoundRectangle>& found, const WallCells& cells, std::int64_t cell) {
  const Place2 middle{(static_cast<double>(cell % cells.columns) + 0.5) * cells.cell,
                      (static_cast<double>(cell / cells.columns) + 0.5) * cells.cell};
  return std::any_of(found.begin(), found.end(), [&](const FoundRectangle& o) { return o.box().contains(middle); });
}

// The parts of cells in which a square of `side` cells has room.
std::vector<UnseenArea> areas_of_cells(const std::vector<bool>& wanted, const WallCells& cells, std::int64_t side) {
  std::vector<bool> obstacles = wanted;
  obstacles.flip();
  const std::vector<bool> wide = covered_by_squares(cells, obstacles, side, 0);
  std::vector<UnseenArea> areas;
  for_each_region(
      cells, [&](std::size_t i) { return wide[i]; },
      [&](const CellRegion& part) {
        WallHole hole;
        hole.region = part;
        hole.box = box_of(part, cells.columns);
        areas.push_back(area_of(hole, cells));
      });
  return areas;
}

// The highest cell of the wall in each column; -1 where there is none. Above it may be the sky.
std::vector<std::int64_t> tops_of(const WallCells& cells) {
  std::vector<std::int64_t> tops(static_cast<std::size_t>(cells.columns), -1);
  for (std::int64_t r = 0; r < cells.rows; ++r)
    for (std::int64_t c = 0; c < cells.columns; ++c)
      if (cells.at(c, r) == kSolid) tops[static_cast<std::size_t>(c)] = r;
  return tops;
}

bool contains(const std::vector<Place2>& ring, Place2 p) {
  const auto flat = [](Place2 q) { return FlatPoint{q.u, q.v}; };
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    inside ^= ray_crosses(flat(p), flat(ring[i]), flat(ring[(i + 1) % ring.size()]));
  return inside;
}

std::int64_t side_of_bare_square(const WallCells& cells, double least_size) {
  return std::max(kLeastSide, static_cast<std::int64_t>(least_size / cells.cell));
}

// Marks what is bare below the top of the wall: cells of no opening and no known area in which neither the wall nor
// anything behind it was seen.
void mark_bare(const WallCells& cells, const std::vector<bool>& silent, const std::vector<bool>& known,
               const std::vector<FoundRectangle>& found, std::vector<bool>& bare) {
  const std::vector<std::int64_t> tops = tops_of(cells);
  for (std::size_t i = 0; i < bare.size(); ++i) {
    const auto at = static_cast<std::int64_t>(i);
    if (cells.what[i] != kUnknown && cells.what[i] != kBlocked && !silent[i]) continue;
    if (known[i] || at / cells.columns > tops[i % static_cast<std::size_t>(cells.columns)]) continue;
    if (!in_opening(found, cells, at)) bare[i] = true;
  }
}

}  // namespace

std::vector<UnseenArea> unseen_areas(const std::vector<WallHole>& holes, const std::vector<FoundRectangle>& found,
                                     const WallCells& cells, const std::vector<bool>& silent, double least_size) {
  std::vector<UnseenArea> areas;
  std::vector<bool> left(cells.what.size(), false), known(left), bare(left);
  for (const WallHole& hole : holes) {
    std::vector<std::uint32_t> outside;
    for (const std::uint32_t i : hole.region.cells)
      if (!in_opening(found, cells, i)) outside.push_back(i);
    const bool whole = outside.size() == hole.region.cells.size();
    if (whole) areas.push_back(area_of(hole, cells));
    for (const std::uint32_t i : outside)
      if (whole || 2 * outside.size() > hole.region.cells.size() || !hole.shows(i, cells.columns))
        (whole ? known : left)[i] = true;
  }
  const auto side = std::max<std::int64_t>(1, static_cast<std::int64_t>(least_size / cells.cell));
  for (UnseenArea& area : areas_of_cells(left, cells, side)) areas.push_back(std::move(area));
  for (std::size_t i = 0; i < known.size(); ++i) known[i] = known[i] || left[i];
  mark_bare(cells, silent, known, found, bare);
  for (UnseenArea& area : areas_of_cells(bare, cells, side_of_bare_square(cells, least_size)))
    areas.push_back(std::move(area));
  return areas;
}

std::vector<UnseenArea> unseen_above_wall(const WallCells& cells, const std::vector<Place2>& outline,
                                          const std::vector<Box2>& drawn, double least_size) {
  const std::vector<std::int64_t> tops = tops_of(cells);
  std::vector<bool> bare(cells.what.size(), false);
  for (std::size_t i = 0; i < bare.size(); ++i) {
    const auto c = static_cast<std::int64_t>(i) % cells.columns, r = static_cast<std::int64_t>(i) / cells.columns;
    if ((cells.what[i] != kUnknown && cells.what[i] != kBlocked) || r <= tops[static_cast<std::size_t>(c)]) continue;
    const Place2 middle{(static_cast<double>(c) + 0.5) * cells.cell, (static_cast<double>(r) + 0.5) * cells.cell};
    const auto covers = [&](const Box2& box) { return box.contains(middle); };
    bare[i] = contains(outline, middle) && std::none_of(drawn.begin(), drawn.end(), covers);
  }
  return areas_of_cells(bare, cells, side_of_bare_square(cells, least_size));
}

}  // namespace ilot
