// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/hidden_side.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace ilot {
namespace {

// Cells of 10 cm of a wall of 3 m by 3 m.
WallCells cells_of_wall() {
  WallCells cells;
  cells.cell = 0.1;
  cells.columns = cells.rows = 30;
  cells.what.assign(900, WallCells::kSolid);
  return cells;
}

void set(WallCells& cells, std::int64_t c0, std::int64_t c1, std::int64_t r0, std::int64_t r1, std::uint8_t what) {
  for (std::int64_t r = r0; r < r1; ++r)
    for (std::int64_t c = c0; c < c1; ++c) cells.at(c, r) = what;
}

TEST(HiddenSide, TheWallBeginsWhereHalfOfTheLinesMeetIt) {
  WallCells cells = cells_of_wall();
  set(cells, 10, 20, 15, 25, WallCells::kThrough);
  set(cells, 10, 20, 8, 15, WallCells::kBlocked);
  const Box2 box{1, 2, 1.5, 2.5};
  EXPECT_NEAR(wall_beyond(cells, box, Side::bottom), 0.7, 1e-9);
  set(cells, 10, 13, 8, 15, WallCells::kSolid);
  EXPECT_NEAR(wall_beyond(cells, box, Side::bottom), 0.7, 1e-9);
  set(cells, 13, 16, 12, 15, WallCells::kSolid);
  EXPECT_NEAR(wall_beyond(cells, box, Side::bottom), 0.1, 1e-9);  // at least a cell
}

// Of three lines, one meets the wall at once: the middle one goes on for 70 cm. A fourth line, beyond the box, meets
// the wall at once too and does not count.
TEST(HiddenSide, LinesBeyondTheBoxDoNotCount) {
  WallCells cells = cells_of_wall();
  set(cells, 3, 6, 8, 25, WallCells::kThrough);
  set(cells, 3, 4, 8, 15, WallCells::kSolid);
  EXPECT_NEAR(wall_beyond(cells, {0.3, 0.6, 1.5, 2.5}, Side::bottom), 0.7, 1e-9);
}

TEST(HiddenSide, WithoutAWallItEndsWithTheCells) {
  WallCells cells = cells_of_wall();
  set(cells, 10, 30, 10, 20, WallCells::kUnknown);
  EXPECT_NEAR(wall_beyond(cells, {1, 1.5, 1, 2}, Side::right), 1.5, 1e-9);
  EXPECT_NEAR(wall_beyond(cells, {1.05, 1.5, 1, 2}, Side::left), 0.1, 1e-9);
}

}  // namespace
}  // namespace ilot
