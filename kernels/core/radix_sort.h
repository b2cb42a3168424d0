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

// Sorts by key, then by value. It is a radix sort from the upper digits: after one pass over memory the rest happens in
// cache. It is O(n) for keys that are spread evenly, and never worse than O(n log n) passes over the 128 bits.
// `scratch` has the size of `pairs`.
void sort_pairs(std::span<KeyValue> pairs, std::span<KeyValue> scratch);

// Returns the permutation that sorts the keys. Equal keys stay in their given order. It needs 32 bytes of working
// memory per key. There are at most 2^32 keys.
std::vector<std::uint32_t> sorted_order(std::span<const std::uint64_t> keys);

}  // namespace ilot
