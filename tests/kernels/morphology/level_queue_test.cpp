// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/level_queue.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// What is pushed while it rises comes out by height, each pixel once and with its own height.
TEST(LevelQueue, LowestFirst) {
  constexpr Height kLow = -50;
  constexpr std::uint32_t kLevels = 200, kPixels = 1000;
  Rng rng(8, 2);
  std::vector<Height> height(kPixels, kNoHeight);
  LevelQueue queue(kLow, kLevels, kPixels);
  std::uint32_t pushed = 0, popped = 0;
  Height level = kLow;
  const auto push = [&] {
    height[pushed] = level + static_cast<Height>(rng.below(static_cast<std::uint32_t>(kLow + 200 - level)));
    queue.push(height[pushed], pushed);
    ++pushed;
  };
  while (pushed < 20) push();
  while (!queue.empty()) {
    const LevelQueue::Item item = queue.pop();
    ++popped;
    EXPECT_GE(item.height(), level);
    EXPECT_EQ(item.height(), height[item.pixel]);
    height[item.pixel] = kNoHeight;  // a second time would differ
    level = item.height();
    for (std::uint32_t n = rng.below(3); n > 0 && pushed < kPixels; --n) push();
  }
  EXPECT_EQ(popped, pushed);
  EXPECT_GE(pushed, 20u);
}

}  // namespace
}  // namespace ilot
