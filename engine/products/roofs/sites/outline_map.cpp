// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/outline_map.h"

#include <algorithm>
#include <utility>

#include "kernels/core/integers.h"

namespace ilot {
namespace {

constexpr std::int64_t kCell = 65536;      // millimetres
constexpr std::int64_t kCellsOfOne = 256;  // outlines over more cells are compared one by one

struct CellRange {
  std::int64_t row0, row1, column0, column1;
  explicit CellRange(const GridBox& box)
      : row0(floor_divided(box.min_y, kCell)),
        row1(floor_divided(box.max_y, kCell)),
        column0(floor_divided(box.min_x, kCell)),
        column1(floor_divided(box.max_x, kCell)) {}
  bool is_large() const {
    const std::int64_t rows = row1 - row0 + 1, columns = column1 - column0 + 1;
    return rows > kCellsOfOne || columns > kCellsOfOne || rows * columns > kCellsOfOne;
  }
};

}  // namespace

PlacedOutline place_outline(const std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>>& rings) {
  PlacedOutline placed;
  GridBox& box = placed.box;
  for (const auto& ring : rings) {
    for (const auto& [x, y] : ring) {
      box = box.empty() ? GridBox{x, y, x, y}
                        : GridBox{std::min(box.min_x, x), std::min(box.min_y, y), std::max(box.max_x, x),
                                  std::max(box.max_y, y)};
    }
  }
  constexpr std::int64_t kMetre = 1000;
  placed.x = floor_divided(box.min_x, kMetre) * kMetre;
  placed.y = floor_divided(box.min_y, kMetre) * kMetre;
  for (const auto& ring : rings) {
    auto& local = placed.polygon.emplace_back();
    for (const auto& [x, y] : ring)
      local.push_back({static_cast<std::int32_t>(x - placed.x), static_cast<std::int32_t>(y - placed.y)});
  }
  return placed;
}

SitePolygon seen_from(const PlacedOutline& outline, std::int64_t x, std::int64_t y) {
  const auto dx = static_cast<std::int32_t>(outline.x - x), dy = static_cast<std::int32_t>(outline.y - y);
  SitePolygon polygon = outline.polygon;
  for (auto& ring : polygon)
    for (Point2& p : ring) p = {p.x + dx, p.y + dy};
  return polygon;
}

OutlineMap::OutlineMap(std::vector<GridBox> boxes) : boxes_(std::move(boxes)) {
  std::size_t count = 0;
  const auto for_each = [&](const auto& visit_cell, const auto& visit_large) {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i].empty()) continue;
      const CellRange cells(boxes_[i]);
      if (cells.is_large()) {
        visit_large(i);
        continue;
      }
      for (std::int64_t row = cells.row0; row <= cells.row1; ++row)
        for (std::int64_t column = cells.column0; column <= cells.column1; ++column) visit_cell(Entry{row, column, i});
    }
  };
  for_each([&](const Entry&) { ++count; }, [](std::uint32_t) {});
  entries_.reserve(count);
  for_each([&](const Entry& e) { entries_.push_back(e); }, [&](std::uint32_t i) { large_.push_back(i); });
  std::sort(entries_.begin(), entries_.end());
}

std::vector<std::uint32_t> OutlineMap::near(const GridBox& box) const {
  std::vector<std::uint32_t> found;
  const CellRange cells(box);
  const std::int64_t last_row = entries_.empty() ? cells.row0 - 1 : std::min(cells.row1, entries_.back().row);
  const std::int64_t first_row = entries_.empty() ? cells.row0 : std::max(cells.row0, entries_.front().row);
  for (std::int64_t row = first_row; row <= last_row; ++row) {
    auto e = std::lower_bound(entries_.begin(), entries_.end(), Entry{row, cells.column0, 0});
    for (; e != entries_.end() && e->row == row && e->column <= cells.column1; ++e) found.push_back(e->outline);
  }
  found.insert(found.end(), large_.begin(), large_.end());
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase_if(found, [&](std::uint32_t i) { return !boxes_[i].meets(box); });
  return found;
}

}  // namespace ilot
