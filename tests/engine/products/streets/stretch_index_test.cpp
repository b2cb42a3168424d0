// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/stretch_index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Oracle: every line is looked at.
BlockAddress address_of(const std::vector<StreetStretch>& stretches, double pixel, double farthest, double x,
                        double y) {
  BlockAddress found;
  double nearest = farthest;
  for (std::uint32_t s = 0; s < stretches.size(); ++s) {
    const StreetStretch& line = stretches[s];
    const double px = (x - line.x) * pixel, py = (y - line.y) * pixel, along = px * line.dx + py * line.dy;
    const double across = std::abs(py * line.dx - px * line.dy);
    const double beyond = std::max({0.0, -along, along - line.length});
    const double distance = std::sqrt(across * across + beyond * beyond);
    if (distance >= nearest) continue;
    nearest = distance;
    double least = INFINITY;
    for (std::uint32_t b = 0; b < line.blocks.size(); ++b) {
      const double outside = std::max({0.0, line.blocks[b].from - along, along - line.blocks[b].to});
      if (outside < least) least = outside, found = {s + 1, b + 1};
    }
  }
  return found;
}

TEST(StretchIndex, EqualsALookAtEveryLine) {
  Rng rng(8);
  const double pixel = 0.2;
  std::vector<StreetStretch> stretches;
  for (int i = 0; i < 40; ++i) {
    StreetStretch line;
    line.x = static_cast<double>(rng.below(8000)) - 4000;
    line.y = static_cast<double>(rng.below(8000)) - 4000;
    const double turn = static_cast<double>(rng.below(1000)) * 0.00314;
    line.dx = std::sin(turn), line.dy = std::cos(turn);
    line.length = 20 + static_cast<double>(rng.below(600));
    line.blocks = {{0, line.length / 3, 9}, {line.length / 2, line.length, 9}};
    stretches.push_back(line);
  }
  stretches.push_back(stretches[3]);  // equally near: the first counts
  for (const double farthest : {5.0, 30.0, 150.0}) {
    const StretchIndex index(stretches, {0.001, pixel}, farthest);
    std::size_t beside = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = static_cast<double>(rng.below(16000)) - 8000, y = static_cast<double>(rng.below(16000)) - 8000;
      const BlockAddress got = index.address(x, y), want = address_of(stretches, pixel, farthest, x, y);
      ASSERT_EQ(got.stretch, want.stretch) << x << " " << y;
      ASSERT_EQ(got.block, want.block) << x << " " << y;
      beside += got.stretch != 0;
    }
    EXPECT_GT(beside, 100u);
  }
}

}  // namespace
}  // namespace ilot
