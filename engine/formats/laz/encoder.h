// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/formats/laz/bit_model.h"
#include "engine/formats/laz/models.h"

namespace ilot::laz {

// Writes an arithmetic stream of LAZ into its own buffer, which it keeps between streams.
class Encoder {
 public:
  static constexpr bool kEncodes = true;
  template <std::uint32_t kCapacity>
  using Model = SymbolModel<kCapacity, false>;

  void start(std::uint32_t epoch) {
    out_.clear();
    base_ = 0;
    length_ = 0xFFFFFFFFu;
    epoch_ = epoch;
  }

  template <std::uint32_t kCapacity>
  std::uint32_t symbol(Model<kCapacity>& model, std::uint32_t s, std::uint32_t symbols = kCapacity) {
    model.prepare(epoch_, symbols);
    const std::uint32_t unit = length_ >> kSymbolShift;
    const std::uint32_t low = model.below(s) * unit;
    const std::uint32_t high = s == model.last_symbol() ? length_ : model.below(s + 1) * unit;
    narrow(low, high - low);
    model.count(s);
    return s;
  }

  std::uint32_t bit(BitModel& model, std::uint32_t b) {
    model.prepare(epoch_);
    const std::uint32_t split = model.zero_share() * (length_ >> kBitShift);
    narrow(b ? split : 0, b ? length_ - split : split);
    model.count(b);
    return b;
  }

  std::uint32_t raw(std::uint32_t k, std::uint32_t v) {
    if (k > 19) {
      few_bits(16, v & 0xFFFF);
      few_bits(k - 16, v >> 16);
    } else {
      few_bits(k, v);
    }
    return v;
  }

  // Ends the stream; the result is valid until the next start().
  std::span<const std::byte> finish() {
    const bool extra = length_ > 2 * kMinLength;
    narrow(extra ? kMinLength : kMinLength >> 1, extra ? kMinLength >> 1 : kMinLength >> 9);
    out_.insert(out_.end(), extra ? 3 : 2, 0);
    return std::as_bytes(std::span(out_));
  }

 private:
  void few_bits(std::uint32_t k, std::uint32_t v) {
    const std::uint32_t unit = length_ >> k;
    narrow(v * unit, unit);
  }

  void narrow(std::uint32_t low, std::uint32_t length) {
    base_ += low;
    if (base_ < low) [[unlikely]]
      carry();
    length_ = length;
    while (length_ < kMinLength) {
      out_.push_back(static_cast<std::uint8_t>(base_ >> 24));
      base_ <<= 8;
      length_ <<= 8;
    }
  }
  // The sum of all bytes so far is below one, so there is a byte that takes the carry.
  void carry() {
    std::size_t i = out_.size() - 1;
    while (out_[i] == 0xFF) out_[i--] = 0;
    ++out_[i];
  }

  std::uint32_t base_ = 0, length_ = 0xFFFFFFFFu;
  std::uint32_t epoch_ = 0;
  std::vector<std::uint8_t> out_;
};

}  // namespace ilot::laz
