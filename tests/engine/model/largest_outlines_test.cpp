// SPDX-License-Identifier: Apache-2.0
#include "engine/model/largest_outlines.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

Outline outline_of(std::uint32_t id, std::size_t corners) {
  return {id, {{Outline::Ring(corners)}}};
}

TEST(LargestOutlines, KeepsAllUntilThereIsNoRoom) {
  LargestOutlines kept(10);
  kept.add(outline_of(1, 4), 1);
  kept.add(outline_of(2, 0), 50);
  kept.add(outline_of(3, 6), 2);
  ASSERT_EQ(kept.outlines().size(), 2u) << "one has no corners";
  EXPECT_EQ(kept.dropped(), 0u);
}

TEST(LargestOutlines, TheSmallestGoFirst) {
  LargestOutlines kept(12);
  kept.add(outline_of(1, 4), 1);
  kept.add(outline_of(2, 3), 9);
  kept.add(outline_of(3, 4), 5);
  kept.add(outline_of(4, 3), 7);  // 14 corners: 6 are left
  ASSERT_EQ(kept.outlines().size(), 2u);
  EXPECT_EQ(kept.outlines()[0].plane_id, 2u);
  EXPECT_EQ(kept.outlines()[1].plane_id, 4u);
  EXPECT_EQ(kept.dropped(), 2u);
}

TEST(LargestOutlines, WithoutRoomNothingIsKept) {
  LargestOutlines kept;
  kept.add(outline_of(1, 4), 1);
  EXPECT_TRUE(kept.outlines().empty());
}

}  // namespace
}  // namespace ilot
