// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/wall_cells.h"

#include <cmath>

#include "engine/products/facades/rays/cell_bands.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: openings below three cells are lost.
constexpr double kLeastCell = 0.02, kMostCell = 0.15;  // metres
// Choice: an arch takes the corners of its box; a gable window ends too far in.
constexpr double kTail = 0.15;  // share of its rows and columns that may end farther out

// Choice: a cable or a leaf of a plant may hide a row in eight; behind a tree an arch is not known as one.
constexpr double kArchRows = 0.87;  // share of the rows that are as those of an arch on jambs
// Choice: the jambs of a wide door below a basket arch are half as high as the door; round windows have none.
constexpr double kJambRows = 0.3;  // share of the rows that end at both jambs

using enum WallCells::What;

// The numbers of rays of a cell.
struct CellCounts {
  std::uint32_t solid = 0, through = 0, shallow = 0, blocked = 0, relief = 0;

  WallCells::What what() const {
    if (through > solid) return kThrough;
    if (solid > 0) return kSolid;
    if (blocked > 0) return 2 * relief > blocked ? kRelief : kBlocked;
    return shallow > 0 ? kShallow : kUnknown;
  }
};

// Counts the rays that cross the rows of cells [r0, r1).
void count_rows(const RaySamples& samples, const WallCellParams& params, std::int64_t r0, std::int64_t r1,
                WallCells& cells) {
  const FacadeSite& site = samples.site();
  std::vector<CellCounts> counts(static_cast<std::size_t>((r1 - r0) * cells.columns));
  const Box2 rows{0, static_cast<double>(cells.columns) * cells.cell, static_cast<double>(r0) * cells.cell,
                  static_cast<double>(r1) * cells.cell};
  for (const Ray& ray : samples.near(rows.grown(cells.cell))) {
    const double w = ray.at.w;
    if (w < -params.farthest) continue;
    const Place2 p = samples.crossing(ray, 0);
    if (p.u < 0 || p.v < 0) continue;
    const auto c = static_cast<std::int64_t>(p.u / cells.cell), r = static_cast<std::int64_t>(p.v / cells.cell);
    if (c >= cells.columns || r < r0 || r >= r1) continue;
    CellCounts& at = counts[static_cast<std::size_t>((r - r0) * cells.columns + c)];
    const bool wall = samples.on_wall(ray);
    if (wall) ++at.solid;
    if (!wall && w < 0) ++(w < -params.least_depth ? at.through : at.shallow);
    if (w > site.epsilon) ++at.blocked;
    if (w > site.epsilon && w <= kFlatRelief) ++at.relief;
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    cells.what[static_cast<std::size_t>(r0 * cells.columns) + i] = counts[i].what();
}

// The first and the last cell of each row and of each column of a region; rows and columns count from its extent.
struct RegionEnds {
  std::vector<std::int64_t> left, right, low, high;
};

RegionEnds ends_of(const CellRegion& region, std::int64_t columns) {
  CellBox all{INT64_MAX, -1, INT64_MAX, -1};
  for (const std::int64_t i : region.cells) {
    all = {std::min(all.c0, i % columns), std::max(all.c1, i % columns), std::min(all.r0, i / columns),
           std::max(all.r1, i / columns)};
  }
  RegionEnds ends;
  ends.left.assign(static_cast<std::size_t>(all.rows()), INT64_MAX), ends.right.assign(ends.left.size(), -1);
  ends.low.assign(static_cast<std::size_t>(all.columns()), INT64_MAX), ends.high.assign(ends.low.size(), -1);
  for (const std::int64_t i : region.cells) {
    const auto r = static_cast<std::size_t>(i / columns - all.r0), c = static_cast<std::size_t>(i % columns - all.c0);
    ends.left[r] = std::min(ends.left[r], i % columns), ends.right[r] = std::max(ends.right[r], i % columns);
    ends.low[c] = std::min(ends.low[c], i / columns), ends.high[c] = std::max(ends.high[c], i / columns);
  }
  return ends;
}

// Each end becomes the median of three, so that a single row on which a stray point lies does not count.
void smooth(std::vector<std::int64_t>& ends) {
  std::vector<std::int64_t> out = ends;
  for (std::size_t i = 1; i + 1 < ends.size(); ++i)
    out[i] = std::max(std::min(ends[i - 1], ends[i]), std::min(std::max(ends[i - 1], ends[i]), ends[i + 1]));
  ends = std::move(out);
}

// The share of the ends within one cell of the best line beside a side of the box, which is where the farthest ones
// end. 1 where there are none.
double share_on_line(const std::vector<std::int64_t>& ends, std::int64_t side) {
  if (ends.empty()) return 1;
  std::int64_t most = 0;
  for (std::int64_t line = side - 1; line <= side + 1; ++line)
    most = std::max<std::int64_t>(
        most, std::count_if(ends.begin(), ends.end(), [&](std::int64_t i) { return std::abs(i - line) <= 1; }));
  return static_cast<double>(most) / static_cast<double>(ends.size());
}

}  // namespace

WallCells wall_grid(const FacadeSite& site) {
  WallCells cells;
  cells.cell = cell_for(site.width, site.height, std::clamp(kStepsACell * site.step, kLeastCell, kMostCell));
  cells.columns = static_cast<std::int64_t>(site.width / cells.cell) + 1;
  cells.rows = static_cast<std::int64_t>(site.height / cells.cell) + 1;
  cells.what.assign(static_cast<std::size_t>(cells.columns * cells.rows), kUnknown);
  return cells;
}

WallCells cells_of(const RaySamples& samples, const WallCellParams& params) {
  WallCells cells = wall_grid(samples.site());
  for (const RowBand& band : bands_of(cells.columns, cells.rows))
    count_rows(samples, params, band.first, band.end, cells);
  return cells;
}

WallCells filled(const WallCells& cells, double longest) {
  WallCells out = cells;
  const auto most = static_cast<std::int64_t>(longest / cells.cell) + 1;
  const auto most_shallow = static_cast<std::int64_t>(kWidestBar / cells.cell) + 1;
  const auto fill_line = [&](std::int64_t c, std::int64_t r, std::int64_t dc, std::int64_t dr, std::int64_t length) {
    std::int64_t last = -1, shallow = 0, relief = 0;
    for (std::int64_t i = 0; i < length; ++i) {
      const std::uint8_t what = cells.at(c + i * dc, r + i * dr);
      shallow += what == kShallow, relief += dc != 0 && what == kRelief;
      if (what == kThrough) {
        if (last >= 0 && i - last <= most && shallow <= most_shallow && relief <= most_shallow)
          for (std::int64_t k = last + 1; k < i; ++k) out.at(c + k * dc, r + k * dr) = kThrough;
        last = i;
        shallow = relief = 0;
      } else if (what == kSolid) {
        last = -1;
      }
    }
  };
  for (std::int64_t r = 0; r < cells.rows; ++r) fill_line(0, r, 1, 0, cells.columns);
  for (std::int64_t c = 0; c < cells.columns; ++c) fill_line(c, 0, 0, 1, cells.rows);
  return out;
}

// Sums over rectangles give both the obstacles of each square and the squares over each cell.
std::vector<bool> covered_by_squares(const WallCells& cells, const std::vector<bool>& obstacles, std::int64_t side,
                                     double stray) {
  const std::int64_t columns = cells.columns, rows = cells.rows, wide = columns + 1;
  std::vector<std::int32_t> sums(static_cast<std::size_t>(wide * (rows + 1)), 0), squares(sums.size(), 0);
  const auto at = [&](std::int64_t c, std::int64_t r) { return static_cast<std::size_t>(r * wide + c); };
  const auto is_obstacle = [&](std::int64_t c, std::int64_t r) {
    return obstacles[static_cast<std::size_t>(r * columns + c)];
  };
  for (std::int64_t r = 0; r < rows; ++r)
    for (std::int64_t c = 0; c < columns; ++c)
      sums[at(c + 1, r + 1)] = sums[at(c, r + 1)] + sums[at(c + 1, r)] - sums[at(c, r)] + is_obstacle(c, r);
  const auto most = static_cast<std::int32_t>(stray * static_cast<double>(side * side));
  for (std::int64_t r = 0; r + side <= rows; ++r)
    for (std::int64_t c = 0; c + side <= columns; ++c) {
      const std::int64_t c1 = c + side, r1 = r + side;
      if (sums[at(c1, r1)] - sums[at(c, r1)] - sums[at(c1, r)] + sums[at(c, r)] > most) continue;
      ++squares[at(c, r)], --squares[at(c1, r)], --squares[at(c, r1)], ++squares[at(c1, r1)];
    }
  std::vector<bool> covered(cells.what.size(), false);
  for (std::int64_t r = 0; r <= rows; ++r)
    for (std::int64_t c = 0; c <= columns; ++c) {
      if (c > 0) squares[at(c, r)] += squares[at(c - 1, r)];
      if (r > 0) squares[at(c, r)] += squares[at(c, r - 1)];
      if (c > 0 && r > 0) squares[at(c, r)] -= squares[at(c - 1, r - 1)];
      if (c < columns && r < rows)
        covered[static_cast<std::size_t>(r * columns + c)] = squares[at(c, r)] > 0 && !is_obstacle(c, r);
    }
  return covered;
}

CellBox box_of(const CellRegion& region, std::int64_t columns) {
  RegionEnds ends = ends_of(region, columns);
  return {lower_quantile(ends.left, kTail), lower_quantile(ends.right, 1 - kTail), lower_quantile(ends.low, kTail),
          lower_quantile(ends.high, 1 - kTail)};
}

bool has_arched_top(const CellRegion& region, const CellBox& box, std::int64_t columns) {
  RegionEnds ends = ends_of(region, columns);
  const std::int64_t first = *std::min_element(ends.low.begin(), ends.low.end());
  smooth(ends.left), smooth(ends.right);
  std::int64_t jambs = 0, rows = 0, symmetric = 0, falling = 0, left = box.c0, right = box.c1;
  for (std::size_t r = 0; r < ends.left.size(); ++r) {
    const std::int64_t row = first + static_cast<std::int64_t>(r);
    if (row < box.r0 || ends.right[r] < 0) continue;
    ++rows;
    symmetric += std::abs(ends.left[r] - box.c0 - (box.c1 - ends.right[r])) <= 2;
    falling += ends.left[r] >= left - 1 && ends.right[r] <= right + 1;
    jambs += ends.left[r] <= box.c0 + 1 && ends.right[r] >= box.c1 - 1;
    left = std::max(left, ends.left[r]), right = std::min(right, ends.right[r]);
  }
  const auto all = static_cast<double>(rows);
  return static_cast<double>(symmetric) >= kArchRows * all && static_cast<double>(falling) >= kArchRows * all &&
         static_cast<double>(jambs) >= kJambRows * all;
}

double straight_share(const CellRegion& region, const CellBox& box, std::int64_t columns) {
  const RegionEnds ends = ends_of(region, columns);
  return std::min(
      {share_on_line(ends.left, box.c0), share_on_line(ends.right, box.c1), share_on_line(ends.low, box.r0)});
}

double straight_share_at_wall(const CellRegion& region, const CellBox& box, const WallCells& cells) {
  const RegionEnds ends = ends_of(region, cells.columns);
  const std::int64_t row = *std::min_element(ends.low.begin(), ends.low.end());
  const std::int64_t column = *std::min_element(ends.left.begin(), ends.left.end());
  const auto is_wall = [&](std::int64_t c, std::int64_t r) {
    if (c < 0 || r < 0 || c >= cells.columns) return false;
    return cells.at(c, r) == kSolid || cells.at(c, r) == kRelief;
  };
  std::vector<std::int64_t> left, right, low;
  for (std::size_t i = 0; i < ends.left.size(); ++i) {
    const std::int64_t r = row + static_cast<std::int64_t>(i);
    if (ends.right[i] < 0) continue;
    if (is_wall(ends.left[i] - 1, r)) left.push_back(ends.left[i]);
    if (is_wall(ends.right[i] + 1, r)) right.push_back(ends.right[i]);
  }
  for (std::size_t i = 0; i < ends.low.size(); ++i)
    if (ends.high[i] >= 0 && is_wall(column + static_cast<std::int64_t>(i), ends.low[i] - 1))
      low.push_back(ends.low[i]);
  const auto enough = [&](const std::vector<std::int64_t>& at) {
    return static_cast<double>(at.size()) >= kJambRows * static_cast<double>(box.rows());
  };
  if (!enough(left) || !enough(right)) return 0;
  return std::min({share_on_line(left, box.c0), share_on_line(right, box.c1), share_on_line(low, box.r0)});
}

}  // namespace ilot
