// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/region_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace ilot {
namespace {

// Derived: more than half, so that one line is never both.
constexpr double kHalfOfLine = 0.5;  // share of a line of the box that the region, or the wall, takes

// Derived: a strip of whole cells is wider by less than one cell at each end.
constexpr std::int64_t kPartCells = 2;

// In cells: the narrowest part, the narrowest pier, and the narrowest strip of cells that a pier may show as.
struct PartSizes {
  std::int64_t least, pier, strip;
  const WidthOfWall& width;
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
    if (c < box.c0 || c > box.c1 || r < box.r0 || r > box.r1) continue;
    const auto k = static_cast<std::size_t>((upright ? c : r) - lines.first);
    // Leaves on a pier, over which cells were joined. Across a window they are bars and rails.
    const bool relief = cells.at(c, r) == WallCells::kRelief;
    lines.region[k] += !(upright && relief);
    lines.wall[k] -= !upright && relief;
  }
  return lines;
}

// The line at which a region is to be cut, which belongs to no part.
std::optional<std::int64_t> cut_of(const RegionLines& lines, const CellBox& box, const PartSizes& sizes, bool upright) {
  const auto is_pier = [&](std::size_t line, std::int64_t strip) {
    if (strip >= sizes.pier) return true;
    return upright && sizes.width && strip >= sizes.strip &&
           sizes.width(box, lines.first + static_cast<std::int64_t>(line)) > kWidestBar;
  };
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
    if (broad == sizes.least && at && is_pier(*at, strip)) return lines.first + static_cast<std::int64_t>(*at);
    if (broad >= sizes.least) before = true, at.reset(), strip = 0;
    if (!before) continue;
    strip = std::max(strip, narrow);
    if (!is_broad && takes(lines.wall, k) && (!at || lines.wall[k] > lines.wall[*at])) at = k;
  }
  return std::nullopt;
}

void add_parts(const WallCells& cells, RegionPart part, const PartSizes& sizes, bool upright,
               std::vector<RegionPart>& parts) {
  const CellRegion& region = part.region;
  const std::optional<std::int64_t> cut =
      cut_of(lines_of(cells, region, upright), box_of(region, cells.columns), sizes, upright);
  if (!cut) {
    if (upright) return add_parts(cells, std::move(part), sizes, false, parts);
    parts.push_back(std::move(part));
    return;
  }
  RegionPart low{{}, part.at_pier}, high = low;
  for (const std::uint32_t i : region.cells) {
    const std::int64_t line = upright ? i % cells.columns : i / cells.columns;
    if (line != *cut)
      (line < *cut ? low : high).region.cells.push_back(i);
    else if (upright && cells.what[i] == WallCells::kRelief)
      low.at_pier = high.at_pier = true;
  }
  add_parts(cells, std::move(low), sizes, true, parts);
  add_parts(cells, std::move(high), sizes, true, parts);
}

// Derived: the middle between the density of rays that the wall has and none.
constexpr double kHalf = 0.5;

// A ray beside the middle of a pier: how far, and whether the wall stopped it.
struct BesideMiddle {
  double away = 0;  // metres
  bool solid = false;
};

// How far the wall goes on from the middle; `density` in rays per metre.
double reach_of(std::vector<BesideMiddle>& rays, double density, double step) {
  std::sort(rays.begin(), rays.end(), [](const BesideMiddle& a, const BesideMiddle& b) {
    return a.away != b.away ? a.away < b.away : a.solid && !b.solid;
  });
  double sum = 0, most = 0, reach = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    sum += rays[i].solid ? 1 : -1;
    const double gain = sum - kHalf * density * rays[i].away;
    if (!rays[i].solid || gain <= most) continue;
    most = gain;
    const double next = i + 1 < rays.size() ? rays[i + 1].away : INFINITY;
    reach = rays[i].away + std::min(next - rays[i].away, step) / 2;
  }
  return reach;
}

}  // namespace

double pier_width(const RaySamples& samples, double cell, const CellBox& box, std::int64_t column) {
  const double middle = (static_cast<double>(column) + kHalf) * cell;
  // Derived: a pier as wide as a bar with its middle in any place of the column, and a cell beyond it.
  const double reach = kWidestBar + 2 * cell;
  const Box2 strip{middle - reach, middle + reach, static_cast<double>(box.r0) * cell,
                   static_cast<double>(box.r1 + 1) * cell};
  std::vector<BesideMiddle> left, right;
  double core = 0;
  for (const Ray& ray : samples.near(strip)) {
    const double w = ray.at.w;
    const bool solid = samples.on_wall(ray) || (w > 0 && w <= kFlatRelief);
    const Place2 p = samples.crossing(ray, 0);
    if ((!solid && w > 0) || !strip.contains(p)) continue;
    const double off = p.u - middle;
    (off < 0 ? left : right).push_back({std::abs(off), solid});
    core += solid && std::abs(off) <= kHalf * cell;
  }
  const double density = core / cell, step = samples.site().step;
  return reach_of(left, density, step) + reach_of(right, density, step);
}

std::vector<RegionPart> parts_of_region(const WallCells& cells, const CellRegion& region, double least,
                                        const WidthOfWall& width) {
  const auto pier = static_cast<std::int64_t>(kWidestBar / cells.cell) + 1;
  const PartSizes sizes{std::max<std::int64_t>(1, static_cast<std::int64_t>(least / cells.cell)), pier,
                        std::max<std::int64_t>(1, pier - kPartCells), width};
  std::vector<RegionPart> parts;
  add_parts(cells, {region, false}, sizes, true, parts);
  return parts;
}

}  // namespace ilot
