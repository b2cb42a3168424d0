// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/radix_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>

namespace ilot {
namespace {

constexpr std::size_t kInsertion = 24;  // as many or fewer are sorted by insertion
constexpr int kMostBits = 11;           // of one digit

enum class Result { here, there };  // where the sorted pairs go

void sort_by_insertion(KeyValue* a, std::size_t n) {
  for (std::size_t i = 1; i < n; ++i) {
    const KeyValue x = a[i];
    std::size_t at = i;
    for (; at > 0 && x < a[at - 1]; --at) a[at] = a[at - 1];
    a[at] = x;
  }
}

// A digit of the bits in which keys still differ. It is so wide that each bucket gets only a few pairs.
struct Digit {
  int shift = 0, bits = 0;
  std::size_t of(std::uint64_t key) const { return (key >> shift) & ((std::size_t{1} << bits) - 1); }
};

Digit top_digit(std::uint64_t differing, std::size_t n) {
  const int top = std::bit_width(differing), wanted = std::clamp(static_cast<int>(std::bit_width(n)) - 3, 3, kMostBits);
  const int bits = std::min(top, wanted);
  return {top - bits, bits};
}

void sort(KeyValue* here, KeyValue* there, std::size_t n, Result result) {
  std::uint64_t differing = 0;
  if (n > kInsertion)
    for (std::size_t i = 1; i < n; ++i) differing |= here[i].key ^ here[0].key;
  if (differing == 0) {
    if (n <= kInsertion)
      sort_by_insertion(here, n);
    else
      std::sort(here, here + n);  // one key, ordered by value
    if (result == Result::there) std::copy_n(here, n, there);
    return;
  }
  const Digit digit = top_digit(differing, n);
  std::array<std::uint32_t, (std::size_t{1} << kMostBits) + 1> next;
  const std::size_t buckets = std::size_t{1} << digit.bits;
  std::fill_n(next.begin(), buckets + 1, 0u);
  for (std::size_t i = 0; i < n; ++i) ++next[digit.of(here[i].key) + 1];
  for (std::size_t b = 1; b <= buckets; ++b) next[b] += next[b - 1];
  for (std::size_t i = 0; i < n; ++i) there[next[digit.of(here[i].key)]++] = here[i];
  std::size_t first = 0;
  for (std::size_t b = 0; b < buckets; ++b) {  // next[b] is now the end of bucket b
    const std::size_t end = next[b];
    if (end > first)
      sort(there + first, here + first, end - first, result == Result::here ? Result::there : Result::here);
    first = end;
  }
}

}  // namespace

void sort_pairs(std::span<KeyValue> pairs, std::span<KeyValue> scratch) {
  sort(pairs.data(), scratch.data(), pairs.size(), Result::here);
}

std::vector<std::uint32_t> sorted_order(std::span<const std::uint64_t> keys) {
  const std::size_t n = keys.size();
  const auto memory = std::make_unique_for_overwrite<KeyValue[]>(2 * n);
  const std::span<KeyValue> pairs(memory.get(), n);
  for (std::size_t i = 0; i < n; ++i) pairs[i] = {keys[i], i};
  sort_pairs(pairs, {memory.get() + n, n});
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(pairs[i].value);
  return order;
}

}  // namespace ilot
