// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/union_find.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs random_pairs(std::uint32_t n, std::uint32_t count, std::uint64_t key) {
  Rng rng(key);
  Pairs pairs;
  for (std::uint32_t i = 0; i < count; ++i)
    pairs.emplace_back(static_cast<std::uint32_t>(rng.below(n)), static_cast<std::uint32_t>(rng.below(n)));
  return pairs;
}

std::vector<std::uint32_t> representatives(std::uint32_t n, const Pairs& pairs) {
  std::vector<std::uint32_t> parents(n), found;
  UnionFind sets(parents);
  for (const auto& [a, b] : pairs) sets.unite(a, b);
  for (std::uint32_t i = 0; i < n; ++i) found.push_back(sets.find(i));
  return found;
}

// Oracle: labels are overwritten with the smaller one until nothing changes.
std::vector<std::uint32_t> by_relabelling(std::uint32_t n, const Pairs& pairs) {
  std::vector<std::uint32_t> label(n);
  std::iota(label.begin(), label.end(), 0u);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : pairs) {
      changed = changed || label[a] != label[b];
      label[a] = label[b] = std::min(label[a], label[b]);
    }
  }
  return label;
}

TEST(UnionFind, FiveByHand) {
  std::vector<std::uint32_t> parents(5, 99);
  UnionFind sets(parents);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(sets.find(i), i);
  EXPECT_TRUE(sets.unite(4, 2));
  EXPECT_TRUE(sets.unite(3, 4));
  EXPECT_FALSE(sets.unite(2, 3));
  EXPECT_FALSE(sets.unite(1, 1));
  EXPECT_EQ(sets.find(3), 2u);
  EXPECT_EQ(sets.find(0), 0u);
}

TEST(UnionFind, EqualsRelabellingAndRootsAreTheSmallest) {
  for (const std::uint32_t n : {1u, 2u, 50u, 400u})
    for (const std::uint32_t count : {0u, n / 4, n, 3 * n}) {
      const Pairs pairs = random_pairs(n, count, n * 1000 + count);
      EXPECT_EQ(representatives(n, pairs), by_relabelling(n, pairs)) << n << " " << count;
    }
}

TEST(UnionFind, OrderOfUnionsDoesNotShow) {
  Pairs pairs = random_pairs(300, 250, 5);
  const auto wanted = representatives(300, pairs);
  Rng rng(6);
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = pairs.size(); i > 1; --i) std::swap(pairs[i - 1], pairs[rng.below(i)]);
    for (auto& [a, b] : pairs)
      if (rng.below(2) == 0) std::swap(a, b);
    EXPECT_EQ(representatives(300, pairs), wanted);
  }
}

TEST(UnionFind, CountsMergesOnALongChain) {
  constexpr std::uint32_t n = 200000;
  std::vector<std::uint32_t> parents(n);
  UnionFind sets(parents);
  std::uint32_t merged = 0;
  for (std::uint32_t i = n - 1; i > 0; --i) merged += sets.unite(i - 1, i);
  EXPECT_EQ(merged, n - 1);
  EXPECT_EQ(sets.find(n - 1), 0u);
}

TEST(UnionFind, SameAgreesWithFind) {
  Rng rng(4);
  std::vector<std::uint32_t> parents(500);
  UnionFind sets(parents);
  for (int i = 0; i < 300; ++i) {
    sets.unite(static_cast<std::uint32_t>(rng.below(500)), static_cast<std::uint32_t>(rng.below(500)));
    const auto a = static_cast<std::uint32_t>(rng.below(500)), b = static_cast<std::uint32_t>(rng.below(500));
    const bool same = sets.same(a, b);
    EXPECT_EQ(same, sets.find(a) == sets.find(b));
  }
}

}  // namespace
}  // namespace ilot
