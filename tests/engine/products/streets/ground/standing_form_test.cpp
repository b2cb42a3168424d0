// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/standing_form.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kSideOfCell = 400;  // millimetres

// 200 points of a cell: x and y by `plan`, heights from 1.5 m to 8 m.
template <class Plan>
StandingForm shape_of(const Plan& plan) {
  Rng rng(5);
  StandingPoints cell;
  for (int i = 0; i < 200; ++i) {
    const auto [x, y] = plan(rng);
    cell.add(x, y, 1500 + static_cast<Height>(rng.below(6500)), 1500);
  }
  return cell.shape(kSideOfCell);
}

std::int64_t any(Rng& rng, std::uint64_t below) {
  return static_cast<std::int64_t>(rng.below(below));
}

TEST(StandingForm, TellsWallsPolesAndCrowns) {
  EXPECT_EQ(shape_of([](Rng& r) { return std::pair{any(r, 400), 150 + any(r, 40)}; }), StandingForm::upright);
  EXPECT_EQ(shape_of([](Rng& r) {
              const std::int64_t x = any(r, 400);
              return std::pair{x, x + any(r, 30)};
            }),
            StandingForm::upright)
      << "aslant";
  EXPECT_EQ(shape_of([](Rng& r) { return std::pair{150 + any(r, 80), 150 + any(r, 80)}; }), StandingForm::pole);
  EXPECT_EQ(shape_of([](Rng& r) { return std::pair{any(r, 400), any(r, 400)}; }), StandingForm::volume);
}

TEST(StandingForm, TellsRoofs) {
  Rng rng(7);
  StandingPoints roof, few;
  for (int i = 0; i < 12; ++i) {
    const std::int64_t x = any(rng, 400), y = any(rng, 400);
    roof.add(x, y, static_cast<Height>(6000 + x + any(rng, 20)), 1500);
    if (i < 4) few.add(x, y, 6000, 1500);
  }
  EXPECT_EQ(roof.shape(kSideOfCell), StandingForm::inclined);
  EXPECT_EQ(few.shape(kSideOfCell), StandingForm::none) << "too few points";
  EXPECT_GE(roof.top(), 6000);
}

TEST(StandingForm, UprightPixels) {
  const BinRange ten_metres{2, 20};
  EXPECT_TRUE(is_upright(0x1ffffc, ten_metres));
  EXPECT_FALSE(is_upright(0x1ff000, ten_metres)) << "a crown from 6 m up";
  EXPECT_TRUE(is_upright(0x0003fc, ten_metres)) << "a wall of 5 m below a crown";
  EXPECT_FALSE(is_upright(0x00000c, ten_metres)) << "something of 2 m below a crown";
  EXPECT_TRUE(is_upright(0x00000c, {2, 3})) << "a wall that is cut at 2 m";
  EXPECT_FALSE(is_upright(0, {2, 1}));
}

}  // namespace
}  // namespace ilot
