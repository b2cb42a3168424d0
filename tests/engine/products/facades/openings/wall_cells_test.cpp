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

}  // namespace
}  // namespace ilot
