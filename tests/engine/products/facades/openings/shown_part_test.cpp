// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "engine/products/facades/openings/silent_holes.h"

namespace ilot {
namespace {

constexpr double kCell = 0.1;             // metres
constexpr CellBox kHole{20, 49, 10, 49};  // 3 m by 4 m
constexpr std::int64_t kHoleColumns = 30, kHoleRows = 40;

template <class Is>
std::vector<bool> behind_where(const Is& is) {
  std::vector<bool> behind;
  for (std::int64_t r = 0; r < kHoleRows; ++r)
    for (std::int64_t c = 0; c < kHoleColumns; ++c) behind.push_back(is(c, r));
  return behind;
}

TEST(ShownPart, EndsAtTheStraightHeadOfWhatIsSeenBehind) {
  const auto frame = [](std::int64_t c, std::int64_t r) { return r <= 28 && (r == 28 || c % 5 == 0); };
  const auto part = shown_part(kHole, behind_where(frame), kCell);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->r0, kHole.r0);
  EXPECT_EQ(part->r1, kHole.r0 + 28);
  EXPECT_EQ(part->c0, kHole.c0);
  EXPECT_EQ(part->c1, kHole.c1);
}

TEST(ShownPart, ARaggedEndOrANearOneCutsNothing) {
  const auto is_whole = [](const std::optional<CellBox>& part) {
    return part && part->r0 == kHole.r0 && part->r1 == kHole.r1 && part->c0 == kHole.c0 && part->c1 == kHole.c1;
  };
  EXPECT_TRUE(is_whole(shown_part(kHole, behind_where([](auto c, auto r) { return r <= 15 + c % 14; }), kCell)));
  EXPECT_TRUE(is_whole(shown_part(kHole, behind_where([](auto, auto r) { return r <= 35; }), kCell)));
}

TEST(ShownPart, RevealsAloneSayNothing) {
  EXPECT_FALSE(shown_part(kHole, behind_where([](auto c, auto r) { return c >= 28 && r <= 28; }), kCell));
  EXPECT_FALSE(shown_part(kHole, behind_where([](auto, auto) { return false; }), kCell));
}

}  // namespace
}  // namespace ilot
