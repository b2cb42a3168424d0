// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/barred_holes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

constexpr std::int64_t kColumns = 60, kRows = 60;

WallCells wall_of_cells(double cell) {
  return {cell, kColumns, kRows, std::vector<std::uint8_t>(kColumns * kRows, WallCells::kSolid)};
}

WallHole hole_in(const CellBox& box) {
  WallHole hole;
  hole.box = box;
  hole.straight = true;
  for (std::int64_t r = box.r0; r <= box.r1; ++r)
    for (std::int64_t c = box.c0; c <= box.c1; ++c)
      hole.region.cells.push_back(static_cast<std::uint32_t>(r * kColumns + c));
  return hole;
}

TEST(BarredHoles, FourPanesAreOneHoleWithTheirBars) {
  const std::vector<WallHole> panes{hole_in({10, 19, 10, 19}), hole_in({21, 30, 10, 19}), hole_in({10, 19, 22, 40}),
                                    hole_in({21, 30, 22, 40})};
  const std::vector<CellRegion> regions = regions_over_bars(panes, wall_of_cells(0.05));
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].cells.size(), 21u * 31u);
  EXPECT_TRUE(std::is_sorted(regions[0].cells.begin(), regions[0].cells.end()));
}

TEST(BarredHoles, APierAndPanesOfOtherHeightsDivideWindows) {
  const WallCells wall = wall_of_cells(0.05);
  EXPECT_TRUE(regions_over_bars({hole_in({10, 19, 10, 30}), hole_in({24, 33, 10, 30})}, wall).empty()) << "20 cm";
  EXPECT_TRUE(regions_over_bars({hole_in({10, 19, 10, 30}), hole_in({21, 30, 15, 30})}, wall).empty());
}

TEST(BarredHoles, LargeCellsHideAPierButNoWallBetweenStoreys) {
  const WallCells wall = wall_of_cells(0.1);
  EXPECT_TRUE(regions_over_bars({hole_in({10, 19, 10, 30}), hole_in({21, 30, 10, 30})}, wall).empty());
  EXPECT_EQ(regions_over_bars({hole_in({10, 19, 10, 19}), hole_in({10, 19, 21, 30})}, wall).size(), 1u);
}

TEST(BarredHoles, WhatIsNotStraightStaysAlone) {
  std::vector<WallHole> panes{hole_in({10, 19, 10, 19}), hole_in({21, 30, 10, 19})};
  panes[1].straight = false;
  EXPECT_TRUE(regions_over_bars(panes, wall_of_cells(0.05)).empty());
}

}  // namespace
}  // namespace ilot
