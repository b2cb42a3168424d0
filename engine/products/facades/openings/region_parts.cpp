// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/region_parts.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace ilot {
namespace {

// Derived: more than half, so that one line is never both.
constexpr double kHalfOfLine = 0.5;  // share of a line of the box that the region, or the wall, takes

// In cells: the narrowest part and the narrowest pier.
struct PartSizes {
  std::int64_t least, pier;
};

// What the lines across a region show: columns or rows of its box.
struct RegionLines {
  std::int64_t first = 0;
  std::vector<std::int64_t> region, wall;  // cells of each line
  double length = 0;                       // cells of a whole line
};

RegionLines lines_of(const WallCells& cells, const CellRegion& region, bool upright) {
  const CellBox box = box_of(region, cells.columns);
  RegionLines lines;
  lines.first = upright ? box.c0 : box.r0;
  lines.region.assign(static_cast<std::size_t>(upright ? box.columns() : box.rows()), 0);
  lines.wall.assign(lines.region.size(), 0);
  lines.length = static_cast<double>(upright ? box.rows() : box.columns());
  for (std::int64_t r = box.r0; r <= box.r1; ++r)
    for (std::int64_t c = box.c0; c <= box.c1; ++c) {
      const std::uint8_t what = cells.at(c, r);
      lines.wall[static_cast<std::size_t>((upright ? c : r) - lines.first)] +=
          what == WallCells::kSolid || what == WallCells::kRelief;
    }
  for (const std::int64_t i : region.cells) {
    const std::int64_t c = i % cells.columns, r = i / cells.columns;
    if (c >= box.c0 && c <= box.c1 && r >= box.r0 && r <= box.r1)
      ++lines.region[static_cast<std::size_t>((upright ? c : r) - lines.first)];
  }
  return lines;
}

// The line at which a region is to be cut, which belongs to no part.
std::optional<std::int64_t> cut_of(const RegionLines& lines, const PartSizes& sizes) {
  const auto takes = [&](const std::vector<std::int64_t>& of, std::size_t k) {
    return static_cast<double>(of[k]) >= kHalfOfLine * lines.length;
  };
  std::int64_t broad = 0, narrow = 0;  // lines in a row of which the region takes half, and of which it does not
  bool before = false;                 // such a stretch of the region is long enough
  std::optional<std::size_t> at;       // the first of the lines after it of which the wall takes most
  std::int64_t strip = 0;              // lines of the widest strip after it
  for (std::size_t k = 0; k < lines.region.size(); ++k) {
    const bool is_broad = takes(lines.region, k);
    broad = is_broad ? broad + 1 : 0, narrow = is_broad ? 0 : narrow + 1;
    if (broad >= sizes.least && at && strip >= sizes.pier) return lines.first + static_cast<std::int64_t>(*at);
    if (broad >= sizes.least) before = true, at.reset(), strip = 0;
    if (!before) continue;
    strip = std::max(strip, narrow);
    if (!is_broad && takes(lines.wall, k) && (!at || lines.wall[k] > lines.wall[*at])) at = k;
  }
  return std::nullopt;
}

void add_parts(const WallCells& cells, CellRegion region, const PartSizes& sizes, bool upright,
               std::vector<CellRegion>& parts) {
  const std::optional<std::int64_t> cut = cut_of(lines_of(cells, region, upright), sizes);
  if (!cut) {
    if (upright) return add_parts(cells, std::move(region), sizes, false, parts);
    parts.push_back(std::move(region));
    return;
  }
  CellRegion low, high;
  for (const std::uint32_t i : region.cells) {
    const std::int64_t line = upright ? i % cells.columns : i / cells.columns;
    if (line != *cut) (line < *cut ? low : high).cells.push_back(i);
  }
  add_parts(cells, std::move(low), sizes, true, parts);
  add_parts(cells, std::move(high), sizes, true, parts);
}

}  // namespace

std::vector<CellRegion> parts_of_region(const WallCells& cells, const CellRegion& region, double least) {
  const PartSizes sizes{std::max<std::int64_t>(1, static_cast<std::int64_t>(least / cells.cell)),
                        static_cast<std::int64_t>(kWidestBar / cells.cell) + 1};
  std::vector<CellRegion> parts;
  add_parts(cells, region, sizes, true, parts);
  return parts;
}

}  // namespace ilot
