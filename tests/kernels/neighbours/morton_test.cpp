// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/morton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

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

TEST(SortedOrder, EqualsStableSort) {
  Rng rng(4);
  for (const std::size_t n : {0u, 1u, 2u, 1000u}) {
    for (const int shift : {0, 20, 62}) {
      std::vector<std::uint64_t> keys(n);
      for (auto& key : keys) key = rng.next() >> shift;
      std::vector<std::uint32_t> want(n);
      std::iota(want.begin(), want.end(), 0u);
      std::stable_sort(want.begin(), want.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
      EXPECT_EQ(sorted_order(keys), want);
    }
  }
}

}  // namespace
}  // namespace ilot
