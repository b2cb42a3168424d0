// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/parallel_sort.h"

#include <gtest/gtest.h>

#include <functional>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(ParallelSort, IsAsSortingOnOneThread) {
  for (const std::size_t n : {0u, 1u, 2u, 32767u, 32768u, 32769u, 65536u, 100000u, 98304u, 163841u, 300007u}) {
    for (const std::uint64_t kinds : {std::uint64_t{3}, UINT64_MAX}) {
      Rng rng(n + kinds);
      std::vector<std::uint64_t> values(n);
      for (auto& v : values) v = rng.below(kinds);
      std::vector<std::uint64_t> expected = values;
      std::sort(expected.begin(), expected.end());
      for (const int threads : {1, 4}) {
        std::vector<std::uint64_t> sorted = values;
        with_threads(threads, [&] { parallel_sort(sorted, std::less<>()); });
        EXPECT_EQ(sorted, expected) << n << " values of " << kinds;
      }
    }
  }
}

TEST(ParallelSort, SortedAndReversedValues) {
  std::vector<int> up(200000);
  for (std::size_t i = 0; i < up.size(); ++i) up[i] = static_cast<int>(i);
  std::vector<int> down(up.rbegin(), up.rend());
  parallel_sort(down, std::less<>());
  EXPECT_EQ(down, up);
  parallel_sort(down, std::less<>());
  EXPECT_EQ(down, up);
}

}  // namespace
}  // namespace ilot
