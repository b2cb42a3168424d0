// SPDX-License-Identifier: Apache-2.0
// GPS times as bit patterns: up to four interleaved sequences, each predicted by multiples of its last step. kMayRepeat
// selects the variant of point formats 0-5, which can also code that a time equals the last one.
#pragma once
#include <algorithm>
#include <cstdint>

#include "engine/formats/laz/integer_codec.h"

namespace ilot::laz {

template <class Coder, bool kMayRepeat>
class GpsTimeCodec {
 public:
  void start(std::uint64_t first) {
    for (Sequence& s : sequences_) s = {};
    sequences_[0].time = first;
    current_ = newest_ = 0;
  }

  // Encodes or decodes `value` and returns it.
  std::uint64_t code(Coder& coder, std::uint64_t value) {
    for (int turn = 0; turn < kMaxTurns; ++turn) {
      Sequence& s = sequences_[current_];
      const bool steps = s.step != 0;
      std::uint32_t symbol = Coder::kEncodes ? choose(s, value) : 0;
      symbol = steps ? coder.symbol(multiple_, symbol) : coder.symbol(no_step_, symbol);
      const std::uint32_t special = steps ? kFull : kFullWithoutStep;
      if (symbol > special) {
        current_ = (current_ + symbol - special) & 3;
        continue;
      }
      if (symbol == special) {
        code_full(coder, value);
      } else if (!kMayRepeat || symbol != (steps ? kRepeat : 0)) {
        steps ? code_multiple(coder, s, symbol, value) : code_first_step(coder, s, value);
      }
      break;
    }
    return sequences_[current_].time;
  }

 private:
  struct Sequence {
    std::uint64_t time = 0;
    std::int32_t step = 0;
    std::uint32_t extremes = 0;  // steps that differ much from `step`, consecutive or nearly so
  };
  static constexpr std::uint32_t kRepeat = 511;
  static constexpr std::uint32_t kFull = kMayRepeat ? 512 : 511;
  static constexpr std::uint32_t kFullWithoutStep = kMayRepeat ? 2 : 1;
  static constexpr std::uint32_t kManySteps = 500;      // this and its multiple
  static constexpr std::uint32_t kManyBackwards = 510;  // this is the multiple -10
  static constexpr int kMaxTurns = 5;                   // encoders switch once; a damaged stream must end too

  static bool fits(std::uint64_t difference) {
    return static_cast<std::int64_t>(difference) == static_cast<std::int32_t>(difference);
  }

  std::uint32_t choose(const Sequence& s, std::uint64_t value) const {
    const bool steps = s.step != 0;
    const std::uint64_t difference = value - s.time;
    if (kMayRepeat && difference == 0) return steps ? kRepeat : 0;
    if (fits(difference)) {
      return steps ? multiple_of(static_cast<std::int32_t>(difference), s.step) : kFullWithoutStep - 1;
    }
    const std::uint32_t special = steps ? kFull : kFullWithoutStep;
    for (std::uint32_t i = 1; i < 4; ++i) {
      if (fits(value - sequences_[(current_ + i) & 3].time)) return special + i;
    }
    return special;
  }

  // The quotient is computed in double, because old files come from compilers that kept such quotients in wide
  // registers. Builds of LASzip that round the quotient to float choose the neighbouring multiple about once in 10^5
  // times, at the same size.
  static std::uint32_t multiple_of(std::int32_t difference, std::int32_t step) {
    const double ratio = static_cast<double>(difference) / step;
    const double bounded = std::clamp(ratio, -1000.0, 1000.0);
    const auto q = static_cast<std::int32_t>(bounded + (bounded >= 0 ? 0.5 : -0.5));
    if (q >= 0) return std::min(static_cast<std::uint32_t>(q), kManySteps);
    return q > -10 ? kManySteps + static_cast<std::uint32_t>(-q) : kManyBackwards;
  }

  void code_first_step(Coder& coder, Sequence& s, std::uint64_t value) {
    s.step = differences_.code(coder, 0, static_cast<std::int32_t>(value - s.time), 0);
    s.extremes = 0;
    advance(s, s.step);
  }

  void code_multiple(Coder& coder, Sequence& s, std::uint32_t symbol, std::uint64_t value) {
    const std::int32_t factor = symbol <= kManySteps
                                    ? static_cast<std::int32_t>(symbol)
                                    : static_cast<std::int32_t>(kManySteps) - static_cast<std::int32_t>(symbol);
    const auto predicted =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(factor) * static_cast<std::uint32_t>(s.step));
    const auto real = static_cast<std::int32_t>(value - s.time);
    const std::int32_t d = differences_.code(coder, predicted, real, context_of(symbol));
    if (symbol == 1) s.extremes = 0;
    if (symbol == 0 || symbol == kManySteps || symbol == kManyBackwards) note_extreme(s, d);
    advance(s, d);
  }

  static std::uint32_t context_of(std::uint32_t symbol) {
    if (symbol == 0) return 7;
    if (symbol == 1) return 1;
    if (symbol < 10) return 2;
    if (symbol < kManySteps) return 3;
    if (symbol == kManySteps) return 4;
    return symbol < kManyBackwards ? 5 : 6;
  }

  static void note_extreme(Sequence& s, std::int32_t d) {
    if (++s.extremes > 3) {
      s.step = d;
      s.extremes = 0;
    }
  }

  static void advance(Sequence& s, std::int32_t d) {
    s.time += static_cast<std::uint64_t>(static_cast<std::int64_t>(d));
  }

  void code_full(Coder& coder, std::uint64_t value) {
    const auto predicted = static_cast<std::int32_t>(sequences_[current_].time >> 32);
    const std::int32_t high = differences_.code(coder, predicted, static_cast<std::int32_t>(value >> 32), 8);
    const std::uint32_t low = raw32(coder, static_cast<std::uint32_t>(value));
    newest_ = (newest_ + 1) & 3;
    current_ = newest_;
    sequences_[current_] = {static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 | low, 0, 0};
  }

  Sequence sequences_[4];
  std::uint32_t current_ = 0, newest_ = 0;
  typename Coder::template Model<kMayRepeat ? 516 : 515> multiple_;
  typename Coder::template Model<kMayRepeat ? 6 : 5> no_step_;
  IntegerCodec<Coder, 32, 9> differences_;
};

}  // namespace ilot::laz
