// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/wall_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ilot {
namespace {

constexpr std::int64_t kColumns = 40, kRows = 60;

// Whether the cells at which `holds` is true have the form of an opening with an arch.
bool is_arched(const std::function<bool(double, double)>& holds) {
  CellRegion region;
  for (std::int64_t r = 0; r < kRows; ++r)
    for (std::int64_t c = 0; c < kColumns; ++c)
      if (holds(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5))
        region.cells.push_back(static_cast<std::uint32_t>(r * kColumns + c));
  return has_arched_top(region, box_of(region, kColumns), kColumns);
}

TEST(HasArchedTop, JambsAndAHeadThatNarrowsOnBothSidesAlike) {
  const auto below = [](double rise) {
    return [rise](double c, double r) {  // two straight sides that meet at the top
      return r > 5 && r < 55 && std::abs(c - 20) < 12 * std::min(1.0, (55 - r) / rise);
    };
  };
  EXPECT_TRUE(is_arched(below(10)));
  EXPECT_TRUE(is_arched(below(28)));
  EXPECT_TRUE(is_arched([](double c, double r) {  // a half circle
    return r > 5 && std::abs(c - 20) < 12 && (r < 40 || std::hypot(c - 20, r - 40) < 12);
  }));
  EXPECT_TRUE(is_arched([](double c, double r) { return r > 5 && r < 50 && std::abs(c - 20) < 12; }));
}

// Crowns and heads that fall to one side are none.
TEST(HasArchedTop, OtherFormsAreNone) {
  EXPECT_FALSE(is_arched([](double c, double r) { return std::hypot(c - 20, r - 30) < 15; }));
  EXPECT_FALSE(is_arched(
      [](double c, double r) { return r > 5 && r < 55 && c > 8 && c < 8 + 24 * std::min(1.0, (55 - r) / 28); }));
}

// A stray point takes a row of a jamb, here a third of the width.
TEST(HasArchedTop, ASingleRowThatEndsTooEarlyDoesNotCount) {
  EXPECT_TRUE(is_arched([](double c, double r) {
    const bool stray = r > 10 && r < 11 && c < 16;
    return !stray && r > 5 && std::abs(c - 20) < 12 && (r < 40 || std::hypot(c - 20, r - 40) < 12);
  }));
}

CellRegion region_of(const WallCells& cells) {
  CellRegion region;
  for (std::size_t i = 0; i < cells.what.size(); ++i)
    if (cells.what[i] == WallCells::kThrough) region.cells.push_back(static_cast<std::uint32_t>(i));
  return region;
}

// A wall with an opening whose sides are `ragged` cells to and fro.
WallCells wall_with_opening(std::int64_t ragged) {
  WallCells cells{0.1, kColumns, kRows, std::vector<std::uint8_t>(kColumns * kRows, WallCells::kSolid)};
  for (std::int64_t r = 10; r < 40; ++r)
    for (std::int64_t c = 10 + ragged * (r % 3 - 1); c < 30 - ragged * (r % 3 - 1); ++c)
      cells.at(c, r) = WallCells::kThrough;
  return cells;
}

TEST(StraightShare, SidesThatAreKnownToACellAreStraight) {
  for (const std::int64_t ragged : {0, 1}) {
    const CellRegion region = region_of(wall_with_opening(ragged));
    EXPECT_DOUBLE_EQ(straight_share(region, box_of(region, kColumns), kColumns), 1);
  }
  const CellRegion region = region_of(wall_with_opening(4));
  EXPECT_LT(straight_share(region, box_of(region, kColumns), kColumns), 0.5);
}

// Steps that hide the lower end say nothing; a wall that ends the opening in steps does.
TEST(StraightShare, HiddenEndsSayNothing) {
  for (const std::uint8_t what : {WallCells::kBlocked, WallCells::kSolid}) {
    WallCells cells = wall_with_opening(0);
    for (std::int64_t c = 10; c < 30; ++c)
      for (std::int64_t r = 5; r < c; ++r) cells.at(c, r) = what;
    const CellRegion region = region_of(cells);
    const CellBox box = box_of(region, kColumns);
    EXPECT_LT(straight_share(region, box, kColumns), 0.5);
    const double share = straight_share_at_wall(region, box, cells);
    if (what == WallCells::kBlocked)
      EXPECT_GT(share, 0.66);
    else
      EXPECT_LT(share, 0.5);
  }
}

}  // namespace
}  // namespace ilot
