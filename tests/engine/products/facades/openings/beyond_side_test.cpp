// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/beyond_side.h"

#include <gtest/gtest.h>

#include "engine/products/facades/openings/openings.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr double kNoise = 0.004;  // metres
constexpr Vec3 kEye{3, 1.6, 7};

// A wall with a shop window from 0.3 m up: a board of half a metre and the panes 10 cm behind the wall above it.
struct Shop {
  double left = 2, right = 4, bottom = 0.3, board = 0.8, top = 2.8;
  double board_at = -0.02;  // metres before the wall
};

FacadeSite scanned(const Shop& shop, double noise = kNoise) {
  test::ScannedWall wall;
  wall.wall({});
  wall.sheets.clear();
  const double w = wall.width, h = wall.height;
  wall.sheets = {{2, 0, 0, shop.left, 0, h, 1},
                 {2, 0, shop.right, w, 0, h, 1},
                 {2, 0, shop.left, shop.right, 0, shop.bottom, 1},
                 {2, 0, shop.left, shop.right, shop.top, h, 1},
                 {2, shop.board_at, shop.left, shop.right, shop.bottom, shop.board, 1},
                 {2, -0.1, shop.left, shop.right, shop.board, shop.top, 0}};
  return test::scan_wall(wall, kEye, 0.006, 999, noise);
}

double panel_below(const FacadeSite& site, const Shop& shop, Side side = Side::bottom) {
  const RaySamples samples(site);
  return panel_beyond(samples, {shop.left, shop.right, shop.board, shop.top}, 0, side);
}

TEST(BeyondSide, TheBoardBelowAShopWindowIsAsHighAsItIs) {
  for (const double at : {-0.05, -0.02, 0.03, 0.06}) {
    Shop shop;
    shop.board_at = at;
    const double reach = panel_below(scanned(shop), shop);
    EXPECT_GE(reach, 0.45) << at;
    EXPECT_LE(reach, 0.7) << at;
  }
}

TEST(BeyondSide, WhereTheWallGoesOnThereIsNone) {
  Shop shop;
  shop.board_at = 0;
  for (const double noise : {0.001, 0.004, 0.01})
    for (const Side side : kSides) EXPECT_EQ(panel_below(scanned(shop, noise), shop, side), 0) << noise;
}

TEST(BeyondSide, ASillIsNone) {
  Shop shop;
  shop.bottom = 0.68, shop.board_at = 0.05;  // 12 cm high
  EXPECT_EQ(panel_below(scanned(shop), shop), 0);
}

// The place of the bottom stays where the board begins, and its error reaches to the end of the board.
TEST(BeyondSide, TheErrorOfTheBottomReachesToTheEndOfTheBoard) {
  const Shop shop;
  const FacadeSite site = scanned(shop);
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 1u);
  const LocatedEdge& bottom = found[0].side(Side::bottom);
  EXPECT_NEAR(bottom.at, shop.board, 0.03);
  EXPECT_LT(bottom.error, 0.1);
  EXPECT_GE(bottom.form, bottom.at - shop.bottom - 0.05);
  for (const Side side : {Side::left, Side::right, Side::top}) EXPECT_LT(found[0].side(side).form, 0.05);
}

}  // namespace
}  // namespace ilot
