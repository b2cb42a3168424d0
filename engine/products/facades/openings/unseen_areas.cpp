// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/unseen_areas.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ilot {
namespace {

bool in_opening(const std::vector<FoundRectangle>& found, const WallCells& cells, std::int64_t cell) {
  const Place2 middle{(static_cast<double>(cell % cells.columns) + 0.5) * cells.cell,
                      (static_cast<double>(cell / cells.columns) + 0.5) * cells.cell};
  return std::any_of(found.begin(), found.end(), [&](const FoundRectangle& o) { return o.box().contains(middle); });
}

// The parts of cells in which a square of `least_size` has room.
std::vector<UnseenArea> areas_of_cells(const std::vector<bool>& wanted, const WallCells& cells, double least_size) {
  std::vector<bool> obstacles = wanted;
  obstacles.flip();
  const auto side = std::max<std::int64_t>(1, static_cast<std::int64_t>(least_size / cells.cell));
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

}  // namespace

std::vector<UnseenArea> unseen_areas(const std::vector<WallHole>& holes, const std::vector<FoundRectangle>& found,
                                     const WallCells& cells, double least_size) {
  std::vector<UnseenArea> areas;
  std::vector<bool> left(cells.what.size(), false);
  for (const WallHole& hole : holes) {
    std::vector<std::uint32_t> outside;
    for (const std::uint32_t i : hole.region.cells)
      if (!in_opening(found, cells, i)) outside.push_back(i);
    if (outside.size() == hole.region.cells.size())
      areas.push_back(area_of(hole, cells));
    else
      for (const std::uint32_t i : outside)
        left[i] = 2 * outside.size() > hole.region.cells.size() || !hole.shows(i, cells.columns);
  }
  for (UnseenArea& area : areas_of_cells(left, cells, least_size)) areas.push_back(std::move(area));
  return areas;
}

}  // namespace ilot
