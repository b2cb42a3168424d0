// SPDX-License-Identifier: Apache-2.0
// The core of point formats 0-5 in item version 1, which compressors before 2011 wrote: coordinates first, each value
// predicted from the last point.
#pragma once
#include <algorithm>
#include <cstdint>

#include "engine/formats/laz/point10.h"

namespace ilot::laz {

template <class Coder>
class Point10CodecV1 {
 public:
  void start(const Point10& first) {
    last_ = first;
    x_steps_ = y_steps_ = {};
    turn_ = 0;
  }

  // Encodes p, or decodes a point, which is last() then.
  void code(Coder& coder, const Point10& p) {
    Point10 value = Coder::kEncodes ? p : last_;
    const std::uint32_t bits = code_coordinates(coder, value);
    const std::uint32_t changed = coder.symbol(changed_, Coder::kEncodes ? changes(p) : 0);
    if (changed != 0) code_attributes(coder, value, changed, bits);
    last_ = value;
  }

  const Point10& last() const { return last_; }

 private:
  enum Change : std::uint32_t { kSource = 1, kUser = 2, kAngle = 4, kClass = 8, kReturns = 16, kIntensity = 32 };
  using ByteModel = typename Coder::template Model<256>;
  using Steps = std::array<std::int32_t, 3>;  // the last three, used as a ring
  static constexpr std::uint32_t kLastContext = 19;

  std::uint32_t changes(const Point10& p) const {
    return (p.intensity != last_.intensity ? kIntensity : 0u) | (p.returns != last_.returns ? kReturns : 0u) |
           (p.classification != last_.classification ? kClass : 0u) | (p.angle != last_.angle ? kAngle : 0u) |
           (p.user != last_.user ? kUser : 0u) | (p.source != last_.source ? kSource : 0u);
  }

  // Returns the mean number of bits of the steps in x and y, which is a context for the next values.
  std::uint32_t code_coordinates(Coder& coder, Point10& p) {
    p.x = step(coder, x_, x_steps_, last_.x, p.x, 0);
    p.y = step(coder, y_, y_steps_, last_.y, p.y, std::min(x_.last_bits(), kLastContext));
    turn_ = (turn_ + 1) % 3;
    const std::uint32_t bits = (x_.last_bits() + y_.last_bits()) / 2;
    p.z = z_.code(coder, last_.z, p.z, std::min(bits, kLastContext));
    return bits;
  }

  template <class Codec>
  std::int32_t step(Coder& coder, Codec& codec, Steps& steps, std::int32_t last, std::int32_t value,
                    std::uint32_t context) {
    const std::uint32_t real = static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(last);
    const std::int32_t d = codec.code(coder, median(steps), static_cast<std::int32_t>(real), context);
    steps[turn_] = d;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(last) + static_cast<std::uint32_t>(d));
  }

  static std::int32_t median(const Steps& s) {
    return std::max(std::min(s[0], s[1]), std::min(std::max(s[0], s[1]), s[2]));
  }

  void code_attributes(Coder& coder, Point10& p, std::uint32_t changed, std::uint32_t bits) {
    if (changed & kIntensity)
      p.intensity = static_cast<std::uint16_t>(intensity_.code(coder, last_.intensity, p.intensity, 0));
    if (changed & kReturns) p.returns = byte(coder, returns_[last_.returns], p.returns);
    if (changed & kClass) p.classification = byte(coder, classification_[last_.classification], p.classification);
    if (changed & kAngle) p.angle = static_cast<std::uint8_t>(angle_.code(coder, last_.angle, p.angle, bits < 3));
    if (changed & kUser) p.user = byte(coder, user_[last_.user], p.user);
    if (changed & kSource) p.source = static_cast<std::uint16_t>(source_.code(coder, last_.source, p.source, 0));
  }

  static std::uint8_t byte(Coder& coder, ByteModel& model, std::uint32_t value) {
    return static_cast<std::uint8_t>(coder.symbol(model, value));
  }

  Point10 last_;
  Steps x_steps_, y_steps_;
  std::uint32_t turn_;
  typename Coder::template Model<64> changed_;
  IntegerCodec<Coder, 32, 1> x_;
  IntegerCodec<Coder, 32, 20> y_, z_;
  IntegerCodec<Coder, 16, 1> intensity_, source_;
  IntegerCodec<Coder, 8, 2> angle_;
  ByteModel returns_[256], classification_[256], user_[256];
};

}  // namespace ilot::laz
