// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/against.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

ComparedUnit compared(const std::string& id, double x, double y, const std::string& key = "", const char* kind = "a") {
  return {id, key, kind, "", {x, y, 0}};
}

TEST(CompareUnits, KeysGoBeforePlaces) {
  const UnitChanges changes = compare_units({compared("1", 0, 0, "k"), compared("2", 5, 0)},
                                            {compared("8", 5.5, 0), compared("9", 100, 0, "k")}, 1);
  EXPECT_EQ(changes.same, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {1, 0}}));
  EXPECT_TRUE(changes.came.empty());
  EXPECT_TRUE(changes.went.empty());
}

TEST(CompareUnits, TheNearestPairIsOneUnitAndKindsDiffer) {
  const UnitChanges changes = compare_units({compared("1", 0, 0), compared("2", 0.9, 0), compared("3", 9, 9, "", "b")},
                                            {compared("7", 1, 0), compared("8", 9, 9)}, 1);
  EXPECT_EQ(changes.same, (std::vector<std::pair<std::size_t, std::size_t>>{{1, 0}}));
  EXPECT_EQ(changes.came, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(changes.went, (std::vector<std::size_t>{1}));
}

TEST(CompareUnits, WhatMovedLessThanHalfOfAnyGapIsFoundAgain) {
  Rng rng(7);
  std::vector<ComparedUnit> before, now;
  for (int i = 0; i < 500; ++i) {
    before.push_back(compared(std::to_string(i), 4 * (i % 25) - 50, 4 * (i / 25) - 50));
    now.push_back(before.back());
    now.back().middle = now.back().middle + Vec3{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
  }
  std::reverse(now.begin(), now.end());
  const UnitChanges changes = compare_units(now, before, 1.5);
  ASSERT_EQ(changes.same.size(), 500u);
  for (const auto& [a, b] : changes.same) EXPECT_EQ(now[a].id, before[b].id);
}

}  // namespace
}  // namespace ilot
