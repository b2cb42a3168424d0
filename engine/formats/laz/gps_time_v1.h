// SPDX-License-Identifier: Apache-2.0
// GPS times in item version 1: one sequence, predicted by multiples of its last step.
#pragma once
#include <algorithm>
#include <cstdint>

#include "engine/formats/laz/integer_codec.h"

namespace ilot::laz {

template <class Coder>
class GpsTimeCodecV1 {
 public:
  void start(std::uint64_t first) {
    time_ = first;
    step_ = 0;
    extremes_ = 0;
  }

  // Encodes or decodes `value` and returns it.
  std::uint64_t code(Coder& coder, std::uint64_t value) {
    std::uint32_t symbol = Coder::kEncodes ? choose(value) : 0;
    const bool steps = step_ != 0;
    symbol = steps ? coder.symbol(multiple_, symbol) : coder.symbol(no_step_, symbol);
    if (symbol == (steps ? kRepeat : 0)) return time_;
    if (symbol == (steps ? kFull : kFullWithoutStep)) return time_ = raw64(coder, value);
    const auto real = static_cast<std::int32_t>(value - time_);
    const std::int32_t d = steps ? code_multiple(coder, symbol, real) : (step_ = differences_.code(coder, 0, real, 0));
    return time_ += static_cast<std::uint64_t>(static_cast<std::int64_t>(d));
  }

 private:
  static constexpr std::uint32_t kManySteps = 509;  // this and its multiple
  static constexpr std::uint32_t kFull = 510, kRepeat = 511;
  static constexpr std::uint32_t kFullWithoutStep = 2;

  std::uint32_t choose(std::uint64_t value) const {
    const auto difference = static_cast<std::int64_t>(value - time_);
    const bool fits = difference == static_cast<std::int32_t>(difference);
    if (step_ == 0) return difference == 0 ? 0 : fits ? 1 : kFullWithoutStep;
    if (difference == 0) return kRepeat;
    return fits ? multiple_of(static_cast<std::int32_t>(difference)) : kFull;
  }

  // Returns the rounded quotient; a step backwards gives 0. Any choice decodes to the same time.
  std::uint32_t multiple_of(std::int32_t difference) const {
    const double ratio = static_cast<double>(difference) / step_ + 0.5;
    return static_cast<std::uint32_t>(std::clamp(ratio, 0.0, static_cast<double>(kManySteps)));
  }

  std::int32_t code_multiple(Coder& coder, std::uint32_t symbol, std::int32_t real) {
    const auto predicted =
        symbol == 0 ? step_ / 4 : static_cast<std::int32_t>(symbol * static_cast<std::uint32_t>(step_));
    const std::int32_t d = differences_.code(coder, predicted, real, context_of(symbol));
    const bool extreme = symbol == 0 || symbol == kManySteps;
    if (extreme) ++extremes_;
    if (symbol == 1 || (extreme && extremes_ > 3)) {
      step_ = d;
      extremes_ = 0;
    }
    return d;
  }

  static std::uint32_t context_of(std::uint32_t symbol) {
    if (symbol == 0) return 2;
    if (symbol == 1) return 1;
    if (symbol < 10) return 3;
    return symbol < 50 ? 4 : 5;
  }

  std::uint64_t time_;
  std::int32_t step_;
  std::uint32_t extremes_;  // steps backwards or of at least kManySteps since step_ changed
  typename Coder::template Model<512> multiple_;
  typename Coder::template Model<3> no_step_;
  IntegerCodec<Coder, 32, 6> differences_;
};

}  // namespace ilot::laz
