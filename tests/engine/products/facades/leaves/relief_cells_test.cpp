// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/relief_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace ilot {
namespace {

// Cells of 10 cm, row by row from the lowest: '.' wall, ' ' not seen, '|' through, a digit: as many centimetres out.
ReliefCells cells_of(const std::vector<std::string>& rows) {
  ReliefCells relief;
  relief.cells.cell = 0.1;
  relief.cells.columns = static_cast<std::int64_t>(rows[0].size());
  relief.cells.rows = static_cast<std::int64_t>(rows.size());
  for (const std::string& row : rows)
    for (const char c : row) {
      relief.cells.what.push_back(c == '.'   ? WallCells::kSolid
                                  : c == ' ' ? WallCells::kUnknown
                                  : c == '|' ? WallCells::kThrough
                                             : WallCells::kRelief);
      relief.out.push_back(c >= '0' && c <= '9' ? 0.01F * static_cast<float>(c - '0') : 0);
    }
  return relief;
}

std::ptrdiff_t piers_in(const std::vector<std::string>& rows) {
  const std::vector<bool> piers = pier_cells(cells_of(rows), 0.011);
  return std::count(piers.begin(), piers.end(), true);
}

TEST(ReliefCells, APierLiesDeeperThanWhatIsOnBothSides) {
  EXPECT_EQ(piers_in(std::vector<std::string>(6, "..55522555..")), 12);
  EXPECT_EQ(piers_in(std::vector<std::string>(6, "..55544555..")), 0);          // a louvre
  EXPECT_EQ(piers_in(std::vector<std::string>(6, "..555222..")), 0);            // a surround
  EXPECT_EQ(piers_in(std::vector<std::string>(6, "..5552222222222555..")), 0);  // wider than a narrow pier
}

// A leaf between a pipe and a hinge is no pier.
TEST(ReliefCells, WhatIsNarrowerThanAPlateIsNotBesideAPier) {
  EXPECT_EQ(piers_in(std::vector<std::string>(6, "..95559..")), 0);
}

// A plant before one leaf makes single cells of it deeper than others.
TEST(ReliefCells, SingleCellsAreNoPier) {
  EXPECT_EQ(piers_in({"..555555..", "..595555..", "..555955..", "..595595..", "..555555.."}), 0);
}

TEST(ReliefCells, APlateEndsAtTheWallOrAtAPier) {
  const ReliefCells relief = cells_of(std::vector<std::string>(6, "..55522555 |"));
  const std::vector<bool> piers = pier_cells(relief, 0.011);
  const CellBox left{2, 4, 0, 5}, right{7, 9, 0, 5};
  EXPECT_EQ(wall_beyond(relief, piers, left, 0.05, Side::left), 1);
  EXPECT_EQ(wall_beyond(relief, piers, left, 0.05, Side::right), 1);
  EXPECT_EQ(wall_beyond(relief, piers, right, 0.05, Side::right), 0);  // a window
}

TEST(ReliefCells, TheShareOfABoxBeforeWhichSomethingStands) {
  const ReliefCells relief = cells_of({"..55", " |.5"});
  EXPECT_DOUBLE_EQ(relief_share(relief, {0, 0.4, 0, 0.2}), 0.375);
  EXPECT_DOUBLE_EQ(relief_share(relief, {0.2, 0.4, 0, 0.2}), 0.75);
  EXPECT_DOUBLE_EQ(relief_share({}, {0, 1, 0, 1}), 0);
}

}  // namespace
}  // namespace ilot
