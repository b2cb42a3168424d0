// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/cell_cleaning.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ilot {
namespace {

// A floor of 40 x 40 points, 10 apart, and a handful of points 200 above it, 60 apart.
CellPoints floor_and_strays() {
  CellPoints cell;
  const auto add = [&](float x, float y, float z) {
    cell.add(x, y, z);
    cell.normals.push_back({0, 0, 32767, 0});
    cell.core.push_back(z == 0);
    cell.colour_class.push_back(z == 0 ? 1 : 2);
  };
  for (int i = 0; i < 1600; ++i) add(static_cast<float>(10 * (i % 40)), static_cast<float>(10 * (i / 40)), 0);
  for (int i = 0; i < 5; ++i) add(static_cast<float>(60 * i), 100, 200);
  cell.pad();
  return cell;
}

TEST(CellCleaning, EachWayDropsTheStraysAndKeepsTheFloor) {
  const CellPoints cell = floor_and_strays();
  const NeighbourIndex index = build_neighbour_index(cell.points());
  PlaneParams params;
  params.connectivity = 30;
  params.min_points = 20;
  const auto dropped = [&](Cleaning cleaning) {
    const std::vector<std::uint8_t> kept = kept_points(index, cleaning, params);
    EXPECT_EQ(std::accumulate(kept.begin(), kept.begin() + 1600, 0), 1600);
    return 5 - std::accumulate(kept.begin() + 1600, kept.end(), 0);
  };
  EXPECT_EQ(dropped(Cleaning::none), 0);
  EXPECT_EQ(dropped(Cleaning::density), 5);
  EXPECT_EQ(dropped(Cleaning::distance), 5);
  EXPECT_EQ(dropped(Cleaning::isolation), 5);
}

TEST(CellCleaning, OnlyKeepsEverythingOfAPoint) {
  const CellPoints cell = floor_and_strays();
  std::vector<std::uint8_t> kept(cell.size, 0);
  kept[3] = kept[1602] = 1;
  const CellPoints part = only(cell, kept);
  ASSERT_EQ(part.size, 2u);
  EXPECT_EQ(part.x[0], 30);
  EXPECT_EQ(part.z[1], 200);
  EXPECT_EQ(part.core, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(part.colour_class, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_GE(part.x.size(), 18u);
}

}  // namespace
}  // namespace ilot
