// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Keys of many kinds: spread, in a few bits low or high, all equal, two far apart.
std::vector<std::vector<std::uint64_t>> key_sets() {
  std::vector<std::vector<std::uint64_t>> sets;
  Rng rng(4);
  for (const std::size_t n : {0u, 1u, 2u, 24u, 25u, 26u, 1000u, 70000u}) {
    for (const int shift : {0, 1, 20, 44, 58, 62}) {
      std::vector<std::uint64_t> low(n), high(n);
      for (std::size_t i = 0; i < n; ++i) {
        low[i] = rng.next() >> shift;
        high[i] = low[i] << shift;
      }
      sets.push_back(low);
      sets.push_back(high);
    }
    sets.push_back(std::vector<std::uint64_t>(n, 7));
    std::vector<std::uint64_t> two(n, 0);
    if (n > 1) two[n / 2] = ~std::uint64_t{0};
    sets.push_back(two);
  }
  return sets;
}

TEST(SortPairs, EqualsStdSort) {
  Rng rng(5);
  for (const auto& keys : key_sets()) {
    std::vector<KeyValue> pairs, scratch(keys.size());
    for (const std::uint64_t key : keys) pairs.push_back({key, rng.next() >> 60});  // values repeat too
    std::vector<KeyValue> want = pairs;
    std::sort(want.begin(), want.end());
    sort_pairs(pairs, scratch);
    EXPECT_EQ(pairs, want) << keys.size();
  }
}

TEST(SortedOrder, EqualsStableSort) {
  for (const auto& keys : key_sets()) {
    std::vector<std::uint32_t> want(keys.size());
    std::iota(want.begin(), want.end(), 0u);
    std::stable_sort(want.begin(), want.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
    EXPECT_EQ(sorted_order(keys), want) << keys.size();
  }
}

}  // namespace
}  // namespace ilot
