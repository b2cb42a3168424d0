// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/morton.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(Morton, InterleavesBits) {
  EXPECT_EQ(morton_code({1, 0, 0}), 1u);
  EXPECT_EQ(morton_code({0, 1, 0}), 2u);
  EXPECT_EQ(morton_code({0, 0, 1}), 4u);
  EXPECT_EQ(morton_code({3, 3, 3}), 63u);
  EXPECT_EQ(morton_code({0x1fffff, 0x1fffff, 0x1fffff}), (std::uint64_t{1} << 63) - 1);
}

TEST(Morton, RoundTrips) {
  Rng rng(3);
  for (int i = 0; i < 10000; ++i) {
    const Cell3 c{static_cast<std::uint32_t>(rng.below(1 << 21)), static_cast<std::uint32_t>(rng.below(1 << 21)),
                  static_cast<std::uint32_t>(rng.below(1 << 21))};
    EXPECT_EQ(morton_cell(morton_code(c)), c);
  }
}

}  // namespace
}  // namespace ilot
