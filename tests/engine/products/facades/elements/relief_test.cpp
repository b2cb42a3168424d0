// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/relief.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

FoundRectangle rectangle(double u0, double u1, double v0, double v1) {
  FoundRectangle r;
  r.side(Side::left).at = u0, r.side(Side::right).at = u1;
  r.side(Side::bottom).at = v0, r.side(Side::top).at = v1;
  return r;
}

std::vector<FoundRectangle> course_of_five() {
  std::vector<FoundRectangle> stones;
  for (int i = 0; i < 5; ++i) stones.push_back(rectangle(i, i + 0.98, 0, 0.5));
  return stones;
}

TEST(DropPiercedStones, StonesBesideOpeningsStay) {
  std::vector<FoundRectangle> stones = course_of_five();
  drop_pierced_stones({rectangle(0.96, 2.02, 0.49, 2)}, stones);  // two centimetres into three of them
  EXPECT_EQ(stones.size(), 5u);
}

TEST(DropPiercedStones, OneThatAnOpeningCutsIsNone) {
  std::vector<FoundRectangle> stones = course_of_five();
  drop_pierced_stones({rectangle(2.2, 2.6, 0.3, 2)}, stones);
  ASSERT_EQ(stones.size(), 4u);
  EXPECT_EQ(stones[2].box().u0, 3);
}

TEST(DropPiercedStones, FewerThanFourAreNoMasonry) {
  std::vector<FoundRectangle> stones = course_of_five();
  drop_pierced_stones({rectangle(1.5, 2.5, 0.2, 0.4)}, stones);
  EXPECT_TRUE(stones.empty());
}

}  // namespace
}  // namespace ilot
