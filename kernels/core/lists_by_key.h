// SPDX-License-Identifier: Apache-2.0
// Items gathered by key, by counting.
#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ilot {

// The items of each key, one list after the other. Items are numbers from 0, in rising order within a list.
struct ListsByKey {
  std::vector<std::uint32_t> first;  // of each key in `items`, and the end of the last list
  std::vector<std::uint32_t> items;
  std::span<const std::uint32_t> of(std::size_t key) const {
    return std::span(items).subspan(first[key], first[key + 1] - first[key]);
  }
};

// Gathers the items 0 to `count` - 1. keys_of(item, take) calls take(key) for each key of an item. An item may have no
// key, one or several. Keys are below `keys`. It is called twice for each item and must give the same keys. There are
// fewer than 2^32 pairs of item and key. O(keys + pairs).
template <class KeysOf>
ListsByKey lists_by_key(std::size_t keys, std::size_t count, const KeysOf& keys_of) {
  ListsByKey out{std::vector<std::uint32_t>(keys + 1, 0), {}};
  for (std::size_t i = 0; i < count; ++i) keys_of(i, [&](std::size_t key) { ++out.first[key + 1]; });
  std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
  out.items.resize(out.first.back());
  std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
  for (std::size_t i = 0; i < count; ++i)
    keys_of(i, [&](std::size_t key) { out.items[next[key]++] = static_cast<std::uint32_t>(i); });
  return out;
}

}  // namespace ilot
