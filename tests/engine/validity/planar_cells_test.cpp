// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/planar_cells.h"

#include <gtest/gtest.h>

#include <array>

namespace ilot {
namespace {

constexpr std::array<FlatPoint, 3> kTriangle{{{0, 0}, {1000, 0}, {0, 1000}}};

std::size_t cells(const std::vector<FlatEdge>& lines, double least_area = 1) {
  return cell_points(kTriangle, lines, least_area).size();
}

TEST(PlanarCells, CountsWhatLinesCut) {
  EXPECT_EQ(cells({}), 1u);
  EXPECT_EQ(cells({{{-100, 300}, {2000, 300}}}), 2u) << "across and beyond";
  EXPECT_EQ(cells({{{100, 100}, {200, 100}}}), 1u) << "a line that ends inside cuts nothing";
  EXPECT_EQ(cells({{{0, 300}, {700, 300}}, {{300, 0}, {300, 700}}}), 4u) << "crossing";
  EXPECT_EQ(cells({{{0, 0}, {1000, 0}}, {{2000, 0}, {2000, 9}}}), 1u) << "along an edge, and outside";
  EXPECT_EQ(cells({{{100, 100}, {200, 100}}, {{200, 100}, {100, 200}}, {{100, 200}, {100, 100}}}), 2u) << "an island";
}

TEST(PlanarCells, LeavesOutSlivers) {
  EXPECT_EQ(cells({{{0, 1}, {1000, 1}}}), 2u);
  EXPECT_EQ(cells({{{0, 1}, {1000, 1}}}, 2000), 1u);
}

TEST(PlanarCells, PointsLieInside) {
  for (const FlatPoint& p : cell_points(kTriangle, std::vector<FlatEdge>{{{0, 300}, {700, 300}}}, 1)) {
    EXPECT_GT(p.x, 0);
    EXPECT_GT(p.y, 0);
    EXPECT_LT(p.x + p.y, 1000);
    EXPECT_NE(p.y, 300);
  }
}

}  // namespace
}  // namespace ilot
