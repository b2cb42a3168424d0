// SPDX-License-Identifier: Apache-2.0
// The image of a wall in cells: what the rays that cross each cell show.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// The wall in square cells, from its lower left corner, row by row upwards. Each cell has what its rays show.
struct WallCells {
  enum What : std::uint8_t {
    kUnknown,
    kSolid,
    kThrough,
    kBlocked,  // something stands before the wall
    kShallow,  // too shallow to be an opening: joints of stone
    kRelief,   // something flat lies on the wall: open shutters, surrounds
  };

  double cell = 0;  // metres
  std::int64_t columns = 0, rows = 0;
  std::vector<std::uint8_t> what;

  std::uint8_t& at(std::int64_t c, std::int64_t r) { return what[static_cast<std::size_t>(r * columns + c)]; }
  std::uint8_t at(std::int64_t c, std::int64_t r) const { return what[static_cast<std::size_t>(r * columns + c)]; }
};

// Choice: the value of kSurround in arched_top.cpp; open shutters and their hinges fit in.
inline constexpr double kFlatRelief = 0.15;  // metres before the wall at which shutters and surrounds end

// Choice: posts between windows are narrower; wider ones part an opening in two.
inline constexpr double kWidestBar = 0.15;  // metres; bars and frames that are nearly as far out as the wall

// Choice: four points a cell.
inline constexpr double kStepsACell = 2;  // steps across a cell

// Which rays are counted as through the wall, in metres.
struct WallCellParams {
  double least_depth = 0.04;  // a ray that ends less far behind the wall did not go through it
  double farthest = 4;        // rays that end farther behind the wall are not used
};

// The cells of a wall, two steps wide, from 2 to 15 cm; nothing is known of them.
WallCells wall_grid(const FacadeSite& site);

// Counts the rays of each cell of the grid. O(points).
WallCells cells_of(const RaySamples& samples, const WallCellParams& params);

// Fills runs of cells in which nothing was seen, or only something before the wall, if they are between two cells
// through which rays went and no longer than `longest` metres, along rows and columns. Leaves of shutters on a pier
// between two windows are no such run of a row: they are wider than a bar and lie on the wall. A joint from one opening
// to the next is not such a run, because its back was seen. Frames and bars at such a small depth are narrower.
WallCells filled(const WallCells& cells, double longest);

// The cells without an obstacle that some square of `side` cells covers of which obstacles take at most the share
// `stray`. O(cells).
std::vector<bool> covered_by_squares(const WallCells& cells, const std::vector<bool>& obstacles, std::int64_t side,
                                     double stray);

// A connected set of cells, as row * columns + column.
struct CellRegion {
  std::vector<std::uint32_t> cells;
};

// Calls visit(region) for each connected set of cells for which wanted(cell) is true, in the order of their first
// cells. Neighbours share an edge. O(cells).
template <class Wanted, class Visit>
void for_each_region(const WallCells& cells, const Wanted& wanted, const Visit& visit) {
  std::vector<bool> taken(cells.what.size(), false);
  for (std::size_t start = 0; start < taken.size(); ++start) {
    if (taken[start] || !wanted(start)) continue;
    CellRegion region;
    region.cells = {static_cast<std::uint32_t>(start)};
    taken[start] = true;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
      const std::int64_t c = region.cells[i] % cells.columns, r = region.cells[i] / cells.columns;
      const auto take = [&](std::int64_t nc, std::int64_t nr) {
        if (nc < 0 || nr < 0 || nc >= cells.columns || nr >= cells.rows) return;
        const auto n = static_cast<std::size_t>(nr * cells.columns + nc);
        if (taken[n] || !wanted(n)) return;
        taken[n] = true;
        region.cells.push_back(static_cast<std::uint32_t>(n));
      };
      take(c - 1, r), take(c + 1, r), take(c, r - 1), take(c, r + 1);
    }
    visit(region);
  }
}

// Columns and rows, both ends included.
struct CellBox {
  std::int64_t c0 = 0, c1 = 0, r0 = 0, r1 = 0;
  std::int64_t columns() const { return c1 - c0 + 1; }
  std::int64_t rows() const { return r1 - r0 + 1; }
};

inline Box2 box_in_metres(const CellBox& box, double cell) {
  return {static_cast<double>(box.c0) * cell, static_cast<double>(box.c1 + 1) * cell,
          static_cast<double>(box.r0) * cell, static_cast<double>(box.r1 + 1) * cell};
}

// The box of a region: its sides are where the farthest rows and columns end, except for a few. Shadows end other rows
// too early, and single cells go beyond.
CellBox box_of(const CellRegion& region, std::int64_t columns);

// The share of the rows and columns of a region that end within one cell of one line beside a side of its box, at the
// worst of its left, right and lower sides. 1 for a rectangle.
double straight_share(const CellRegion& region, const CellBox& box, std::int64_t columns);

// The same of those rows and columns alone that end at the wall: where something hides an end it says nothing. 0 where
// too few rows end at the wall on the left or on the right.
double straight_share_at_wall(const CellRegion& region, const CellBox& box, const WallCells& cells);

// Whether a region has the form of an opening with an arch: jambs below, and above them rows that become narrower on
// both sides alike, to one or two cells. A rectangle has this form too. O(cells).
bool has_arched_top(const CellRegion& region, const CellBox& box, std::int64_t columns);

// The intermediate images of the search for openings.
struct OpeningSteps {
  WallCells seen, filled;  // as the rays show them; joined over cells in which nothing was seen
};

}  // namespace ilot
