// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/lists_by_key.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(ListsByKey, ItemsOfAKeyAreThoseThatNameIt) {
  Rng rng(3, 1);
  std::vector<std::vector<std::size_t>> keys(200);
  for (auto& own : keys)
    for (std::uint64_t n = rng.below(4); n > 0; --n) own.push_back(rng.below(17));
  const ListsByKey lists = lists_by_key(17, keys.size(), [&](std::size_t item, const auto& take) {
    for (const std::size_t key : keys[item]) take(key);
  });
  std::vector<std::vector<std::uint32_t>> expected(17);
  for (std::uint32_t i = 0; i < keys.size(); ++i)
    for (const std::size_t key : keys[i]) expected[key].push_back(i);
  for (std::size_t key = 0; key < expected.size(); ++key) {
    const auto list = lists.of(key);
    EXPECT_EQ(std::vector<std::uint32_t>(list.begin(), list.end()), expected[key]) << key;
  }
}

TEST(ListsByKey, WithoutItemsAllListsAreEmpty) {
  const ListsByKey lists = lists_by_key(3, 0, [](std::size_t, const auto&) {});
  for (std::size_t key = 0; key < 3; ++key) EXPECT_TRUE(lists.of(key).empty());
}

}  // namespace
}  // namespace ilot
