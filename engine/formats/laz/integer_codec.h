// SPDX-License-Identifier: Apache-2.0
// Integers as correctors to a prediction. First the number of bits k of the corrector is coded with one of kContexts
// models, then its high 8 bits with a model of k, then the rest as raw bits. Values are taken modulo 2^kBits (8, 16 or
// 32).
#pragma once
#include <bit>
#include <cstdint>

#include "engine/formats/laz/arithmetic.h"

namespace ilot::laz {

template <class Coder, std::uint32_t kBits, std::uint32_t kContexts>
class IntegerCodec {
  static_assert(kBits == 8 || kBits == 16 || kBits == 32);

 public:
  using LengthModel = typename Coder::template Model<kBits + 1>;

  // Encodes or decodes `real` and returns it. For 8 and 16 bits the result is in [0, 2^kBits - 1].
  std::int32_t code(Coder& coder, std::int32_t predicted, std::int32_t real, std::uint32_t context) {
    return code(coder, predicted, real, lengths_[context]);
  }
  // The same with a model for the number of bits that the caller gives, for when the number of contexts is not fixed.
  std::int32_t code(Coder& coder, std::int32_t predicted, std::int32_t real, LengthModel& lengths) {
    std::uint32_t corrector = 0;
    if constexpr (Coder::kEncodes) {
      corrector = static_cast<std::uint32_t>(real) - static_cast<std::uint32_t>(predicted);
      if constexpr (kBits == 8) corrector = static_cast<std::uint32_t>(static_cast<std::int8_t>(corrector));
      if constexpr (kBits == 16) corrector = static_cast<std::uint32_t>(static_cast<std::int16_t>(corrector));
    }
    corrector = code_corrector(coder, corrector, lengths);
    const std::uint32_t sum = static_cast<std::uint32_t>(predicted) + corrector;
    return static_cast<std::int32_t>(kBits == 32 ? sum : sum & ((1u << (kBits % 32)) - 1));
  }

  // Returns the bits of the last corrector, which are a context for other values.
  std::uint32_t last_bits() const { return k_; }

 private:
  static constexpr std::uint32_t kHighBits = 8;
  using HighModel = typename Coder::template Model<1u << kHighBits>;

  // Returns the k of the interval [-(2^k - 1), 2^k] that contains the corrector.
  static std::uint32_t bits_of(std::uint32_t corrector) {
    const bool positive = static_cast<std::int32_t>(corrector) > 0;
    return static_cast<std::uint32_t>(std::bit_width(positive ? corrector - 1 : 0u - corrector));
  }

  [[gnu::always_inline]] std::uint32_t code_corrector(Coder& coder, std::uint32_t corrector, LengthModel& lengths) {
    k_ = coder.symbol(lengths, bits_of(corrector));
    if (k_ == 0) return coder.bit(zero_or_one_, corrector);
    if (k_ == 32) return 0x80000000u;
    const bool negative = static_cast<std::int32_t>(corrector) < 0;
    const std::uint32_t mapped = code_mapped(coder, negative ? corrector + (1u << k_) - 1 : corrector - 1);
    // The lower half is negative. Both halves are about equally likely, so there is no branch.
    const std::uint32_t lower_half = mapped < 1u << (k_ - 1);
    return mapped + 1 - (lower_half << k_);
  }

  [[gnu::always_inline]] std::uint32_t code_mapped(Coder& coder, std::uint32_t c) {
    auto& high = high_[k_ - 1];
    if (k_ <= kHighBits) return coder.symbol(high, c, 1u << k_);
    const std::uint32_t low_bits = k_ - kHighBits;
    const std::uint32_t top = coder.symbol(high, Coder::kEncodes ? c >> low_bits : 0);
    return top << low_bits | coder.raw(low_bits, c & ((1u << low_bits) - 1));
  }

  std::uint32_t k_;
  BitModel zero_or_one_;
  LengthModel lengths_[kContexts];
  HighModel high_[kBits == 32 ? 31 : kBits];
};

}  // namespace ilot::laz
