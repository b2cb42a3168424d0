// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/facade_rows.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

Facade house_at(double from, double width, double off, double foot = 0) {
  Facade f;
  f.origin = {from, off, foot};
  f.right = {1, 0, 0}, f.up = {0, 0, 1}, f.out = {0, -1, 0};
  f.width_m = width, f.height_m = 9;
  return f;
}

TEST(FacadeRows, HousesSideBySideAreARowFromLeftToRight) {
  const std::vector<Facade> facades{house_at(16, 8, 0.03), house_at(0, 8, 0), house_at(8, 8, 0.5), house_at(40, 8, 0)};
  const auto rows = facade_rows(facades, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0], (std::vector<std::size_t>{1, 2, 0}));
}

TEST(FacadeRows, WhatStandsBeforeOrBehindAWallIsInItsRow) {
  Facade avant_corps = house_at(-0.05, 5, -0.4), floor = house_at(1, 17, 0.13);
  floor.height_m = 3;
  const std::vector<Facade> facades{house_at(0, 18, 0), house_at(18, 8, 0), avant_corps, floor};
  const auto rows = facade_rows(facades, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0], (std::vector<std::size_t>{0, 2, 3, 1}));
}

TEST(FacadeRows, StoreysCornersAndTheOtherSideAreNone) {
  Facade corner = house_at(8, 8, 0), opposite = house_at(16, 8, 0);
  corner.right = {0, 1, 0}, corner.out = {1, 0, 0};
  opposite.right = {-1, 0, 0}, opposite.out = {0, 1, 0};
  EXPECT_TRUE(facade_rows(std::vector<Facade>{house_at(0, 8, 0), house_at(0, 8, 0.5, 9)}, {}).empty());
  EXPECT_TRUE(facade_rows(std::vector<Facade>{house_at(0, 8, 0), corner}, {}).empty());
  EXPECT_TRUE(facade_rows(std::vector<Facade>{house_at(0, 8, 0), opposite}, {}).empty());
  EXPECT_TRUE(facade_rows(std::vector<Facade>{house_at(0, 8, 0), house_at(8, 8, 3)}, {}).empty());
}

}  // namespace
}  // namespace ilot
