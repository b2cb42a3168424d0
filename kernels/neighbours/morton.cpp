// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/morton.h"

#include <array>

namespace ilot {
namespace {

struct Entry {
  std::uint64_t key;
  std::uint32_t index;
};

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

void scatter(const std::vector<Entry>& from, std::vector<Entry>& to, int shift) {
  std::array<std::uint32_t, kDigits> next{};
  for (const Entry& e : from) ++next[(e.key >> shift) & (kDigits - 1)];
  std::uint32_t sum = 0;
  for (std::uint32_t& n : next) {
    const std::uint32_t count = n;
    n = sum;
    sum += count;
  }
  for (const Entry& e : from) to[next[(e.key >> shift) & (kDigits - 1)]++] = e;
}

}  // namespace

std::vector<std::uint32_t> sorted_order(std::span<const std::uint64_t> keys) {
  std::vector<Entry> entries(keys.size());
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    entries[i] = {keys[i], static_cast<std::uint32_t>(i)};
    differing |= keys[i] ^ keys[0];
  }
  std::vector<Entry> other(keys.size());
  for (int shift = 0; shift < 64; shift += kDigitBits) {
    if (((differing >> shift) & (kDigits - 1)) == 0) continue;
    scatter(entries, other, shift);
    entries.swap(other);
  }
  std::vector<std::uint32_t> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = entries[i].index;
  return order;
}

}  // namespace ilot
