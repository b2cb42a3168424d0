// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/storeys.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

// A house of 12 x 8 m whose lower corner is at (1000, 2000).
PlacedOutline house() {
  const auto mm = [](int x, int y) { return std::pair<std::int64_t, std::int64_t>{1000000 + x, 2000000 + y}; };
  return place_outline({{mm(0, 0), mm(12000, 0), mm(12000, 8000), mm(0, 8000)}});
}

// A window in the southern wall.
FacadeOpening window(double x, double z) {
  return {{1000 + x, 2000, z}, 0, -1};
}

std::vector<FacadeOpening> rows(std::initializer_list<double> heights, int windows = 4) {
  std::vector<FacadeOpening> openings;
  for (const double z : heights)
    for (int i = 0; i < windows; ++i) openings.push_back(window(2 + 2 * i, z));
  return openings;
}

std::optional<std::int64_t> count(const std::vector<FacadeOpening>& openings, double metres_per_unit = 1) {
  return StoreyCounter(openings, metres_per_unit).storeys(house());
}

TEST(Storeys, AreRowsOfOpenings) {
  EXPECT_EQ(count(rows({1.5})), 1);
  EXPECT_EQ(count(rows({1.5, 4.5, 7.5, 10.2})), 4);
  EXPECT_EQ(count(rows({1.5, 3.9, 6.3}, 1)), 3);
}

TEST(Storeys, DoorsFanlightsStairsAndCellarsAreNoStoreys) {
  std::vector<FacadeOpening> openings = rows({1.6, 4.6, 7.6});
  openings.push_back(window(10, 1.05));                                 // a door
  for (const double z : {3.0, 6.0}) openings.push_back(window(11, z));  // stairs
  openings.push_back(window(10, 2.6));                                  // a fanlight
  openings.push_back(window(3, -0.2));                                  // a cellar window
  EXPECT_EQ(count(openings), 3);
}

TEST(Storeys, OnlyOpeningsInTheWallsOfTheOutlineCount) {
  EXPECT_EQ(count({}), std::nullopt);
  EXPECT_EQ(count({{{1006, 1998, 1.5}, 0, -1}}), std::nullopt) << "2 m before the wall";
  EXPECT_EQ(count({{{1006, 1999.3, 1.5}, 0, -1}}), 1) << "below the eaves";
  EXPECT_EQ(count({{{1006, 2000, 1.5}, 0, 1}}), std::nullopt) << "of the neighbour across a party wall";
  EXPECT_EQ(count({{{1006, 2000, 1.5}, 1, 0}}), std::nullopt) << "across the wall";
  EXPECT_EQ(count({{{1012, 2004, 1.5}, 1, 0}}), 1) << "in the eastern wall";
  EXPECT_EQ(count({{{1012.4, 2000, 1.5}, 0, -1}}), std::nullopt) << "of the next house in the row";
}

TEST(Storeys, DoNotDependOnTheOrderOfOpeningsNorOnTheUnit) {
  std::vector<FacadeOpening> openings = rows({1.5, 4.4, 7.1, 7.4, 8.0, 10.4});
  const auto expected = count(openings);
  std::ranges::reverse(openings);
  EXPECT_EQ(count(openings), expected);
  for (FacadeOpening& o : openings) o.middle = (1 / 0.3048) * o.middle;
  EXPECT_EQ(count(openings, 0.3048), expected);
}

}  // namespace
}  // namespace ilot
