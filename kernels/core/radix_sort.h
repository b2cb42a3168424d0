// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

struct KeyValue {
  std::uint64_t key, value;
  friend auto operator<=>(const KeyValue&, const KeyValue&) = default;
};

// Sorts by key, then by value. Radix sort from the top: after one pass over memory the rest happens in cache. O(n) for
// keys that spread, never worse than O(n log n) passes over the 128 bits. `scratch` has the size of `pairs`.
void sort_pairs(std::span<KeyValue> pairs, std::span<KeyValue> scratch);

// Permutation that sorts the keys, equal keys in their given order. 32 bytes of working memory a key; at most 2^32
// keys.
std::vector<std::uint32_t> sorted_order(std::span<const std::uint64_t> keys);

}  // namespace ilot
