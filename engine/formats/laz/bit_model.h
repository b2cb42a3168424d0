// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>

namespace ilot::laz {

constexpr std::uint32_t kBitShift = 13;
constexpr std::uint32_t kBitTotal = 1u << kBitShift;

// The same as SymbolModel, for the symbols 0 and 1.
class BitModel {
 public:
  void prepare(std::uint32_t epoch) {
    if (epoch_ != epoch) [[unlikely]]
      *this = fresh(epoch);
  }
  // Returns the share of zeros, in units of 1 / kBitTotal.
  std::uint32_t zero_share() const { return zero_share_; }
  void count(std::uint32_t bit) {
    zeros_ += bit ^ 1;
    if (--until_ == 0) [[unlikely]]
      update();
  }

 private:
  static BitModel fresh(std::uint32_t epoch) {
    BitModel m;
    m.epoch_ = epoch;
    m.zeros_ = 1;
    m.total_ = 2;
    m.zero_share_ = kBitTotal / 2;
    m.cycle_ = m.until_ = 4;
    return m;
  }
  void update() {
    total_ += cycle_;
    if (total_ > kBitTotal) {
      total_ = (total_ + 1) >> 1;
      zeros_ = (zeros_ + 1) >> 1;
      if (zeros_ == total_) ++total_;
    }
    const std::uint32_t scale = 0x80000000u / total_;
    zero_share_ = (zeros_ * scale) >> (31 - kBitShift);
    cycle_ = std::min((5 * cycle_) >> 2, 64u);
    until_ = cycle_;
  }

  std::uint32_t epoch_;
  std::uint32_t until_;
  std::uint32_t zeros_;
  std::uint32_t total_;
  std::uint32_t zero_share_;
  std::uint32_t cycle_;
};

}  // namespace ilot::laz
