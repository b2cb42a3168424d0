// SPDX-License-Identifier: Apache-2.0
// Adaptive probability models of the LAZ arithmetic coder. A model is all zero bytes before its first use. It belongs
// to the chunk whose epoch it stores and is reset when a coder of another epoch uses it. So a decoder allocates its
// models once, and a new chunk costs nothing for models that it never uses.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace ilot::laz {

constexpr std::uint32_t kMinLength = 0x01000000;  // of the interval of the coder
constexpr std::uint32_t kSymbolShift = 15;
constexpr std::uint32_t kSymbolTotal = 1u << kSymbolShift;

// Returns the width of the lookup table of a model with `symbols` symbols: about two buckets for each symbol, so that
// the search after the lookup rarely takes a step.
constexpr std::uint32_t table_bits(std::uint32_t symbols) {
  std::uint32_t bits = 4;
  while ((1u << bits) < 2 * symbols && bits < 9) ++bits;
  return bits;
}

// A model of at most kCapacity symbols. kLookup: it has the table that decoders use to search.
template <std::uint32_t kCapacity, bool kLookup>
class SymbolModel {
 public:
  static constexpr std::uint32_t kTableBits = table_bits(kCapacity);
  static constexpr std::uint32_t kTableShift = kSymbolShift - kTableBits;
  static_assert(kTableShift >= 6, "targets reach kSymbolTotal + 63, which must fall into the last bucket");

  // Makes the model ready for a chunk; this is cheap when it already is. symbols is in [2, kCapacity].
  void prepare(std::uint32_t epoch, std::uint32_t symbols = kCapacity) {
    if (epoch_ != epoch) [[unlikely]]
      restart(epoch, symbols);
  }

  std::uint32_t last_symbol() const { return last_; }
  // Returns the cumulative frequency below symbol s, in units of 1 / kSymbolTotal. s <= last_symbol() + 1; for that
  // value it is a guard above all others.
  std::uint32_t below(std::uint32_t s) const { return cumulated_[s]; }

  // Returns the largest s with below(s) <= target; target < kSymbolTotal + 64.
  std::uint32_t find(std::uint32_t target) const {
    static_assert(kLookup);
    std::uint32_t s = table_[target >> kTableShift];
    while (cumulated_[s + 1] <= target) ++s;
    return s;
  }

  void count(std::uint32_t s) {
    ++counts_[s];
    if (--until_ == 0) [[unlikely]]
      update();
  }

 private:
  using Entry = std::conditional_t<(kCapacity > 256), std::uint16_t, std::uint8_t>;
  struct NoTable {};
  static constexpr std::uint32_t kBuckets = (1u << kTableBits) + 1;
  static constexpr std::uint32_t kStride = sizeof(std::uint64_t) / sizeof(Entry);
  using Table = std::conditional_t<kLookup, Entry[kBuckets + kStride], NoTable>;
  static constexpr std::uint16_t kGuard = 0xFFFF;

  [[gnu::noinline]] void restart(std::uint32_t epoch, std::uint32_t symbols) {
    epoch_ = epoch;
    last_ = symbols - 1;
    total_ = 0;
    cycle_ = symbols;
    for (std::uint32_t i = 0; i < symbols; ++i) counts_[i] = 1;
    update();
    cycle_ = until_ = (symbols + 6) >> 1;
  }

  [[gnu::noinline]] void update() {
    const std::uint32_t symbols = last_ + 1;
    total_ += cycle_;
    if (total_ > kSymbolTotal) halve(symbols);
    const std::uint32_t scale = 0x80000000u / total_;
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < symbols; ++i) {
      cumulated_[i] = static_cast<std::uint16_t>((scale * sum) >> (31 - kSymbolShift));
      sum += counts_[i];
    }
    cumulated_[symbols] = kGuard;
    if constexpr (kLookup) fill_table();
    cycle_ = std::min((5 * cycle_) >> 2, (symbols + 6) << 3);
    until_ = cycle_;
  }

  void halve(std::uint32_t symbols) {
    total_ = 0;
    for (std::uint32_t i = 0; i < symbols; ++i) {
      counts_[i] = static_cast<std::uint16_t>((counts_[i] + 1) >> 1);
      total_ += counts_[i];
    }
  }

  // table_[b] is the symbol that contains the first target of bucket b. Most symbols have only a few buckets. Each
  // symbol fills kStride of them at once, and the next symbol overwrites the surplus.
  void fill_table() {
    std::uint32_t bucket = 0;
    for (std::uint32_t s = 0; s < last_; ++s) {
      const std::uint32_t end = (cumulated_[s + 1] + (1u << kTableShift) - 1) >> kTableShift;
      fill(bucket, end, s);
      bucket = std::max(bucket, end);
    }
    fill(bucket, kBuckets, last_);
  }

  // Fills [bucket, end) and up to kStride - 1 entries behind.
  void fill(std::uint32_t bucket, std::uint32_t end, std::uint32_t s) {
    const std::uint64_t every =
        static_cast<std::uint64_t>(s) * (sizeof(Entry) == 1 ? 0x0101010101010101u : 0x0001000100010001u);
    do {
      std::memcpy(table_ + bucket, &every, sizeof every);
      bucket += kStride;
    } while (bucket < end);
  }

  std::uint32_t epoch_;
  std::uint32_t until_;
  std::uint32_t last_;
  std::uint32_t total_;
  std::uint32_t cycle_;
  std::uint16_t counts_[kCapacity];
  std::uint16_t cumulated_[kCapacity + 1];
  Table table_;
};

}  // namespace ilot::laz
