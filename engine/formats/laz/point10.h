// SPDX-License-Identifier: Apache-2.0
// The core of point formats 0-5: coordinates, intensity, returns, class, angle, user data, source.
#pragma once
#include <cstdint>

#include "engine/cloud/record.h"
#include "engine/formats/laz/integer_codec.h"
#include "engine/formats/laz/predict.h"

namespace ilot::laz {

struct Point10 {  // as in the file
  std::int32_t x, y, z;
  std::uint16_t intensity;
  std::uint8_t returns;  // bits 0-2 return number, 3-5 number of returns, 6 scan direction, 7 edge
  std::uint8_t classification;
  std::uint8_t angle;
  std::uint8_t user;
  std::uint16_t source;

  void to(std::byte* record) const {
    store(record, x);
    store(record + 4, y);
    store(record + 8, z);
    store(record + 12, intensity);
    store(record + 14, returns);
    store(record + 15, classification);
    store(record + 16, angle);
    store(record + 17, user);
    store(record + 18, source);
  }
};
static_assert(sizeof(Point10) == 20);

template <class Coder>
class Point10Codec {
 public:
  void start(const Point10& first) {
    last_ = first;
    for (std::uint32_t i = 0; i < 16; ++i) x_steps_[i] = y_steps_[i] = {};
    std::fill(std::begin(last_intensity_), std::end(last_intensity_), std::uint16_t{0});
    std::fill(std::begin(last_z_), std::end(last_z_), 0);
  }

  // Encodes p, or decodes a point, which is last() then. Decoding works in place, value by value: a copy of fields that
  // were just written would wait for all of them, and so would the next point.
  void code(Coder& coder, const Point10& p) {
    const std::uint32_t changed = coder.symbol(changed_, Coder::kEncodes ? changes(p) : 0);
    if constexpr (Coder::kEncodes) {
      Point10 value = p;
      code_values(coder, value, changed);
      last_ = value;
    } else {
      code_values(coder, last_, changed);
    }
  }

  const Point10& last() const { return last_; }

 private:
  enum Change : std::uint32_t { kSource = 1, kUser = 2, kAngle = 4, kClass = 8, kIntensity = 16, kReturns = 32 };
  using ByteModel = typename Coder::template Model<256>;

  static std::uint8_t byte(Coder& coder, ByteModel& model, std::uint32_t value) {
    return static_cast<std::uint8_t>(coder.symbol(model, value));
  }

  std::uint32_t changes(const Point10& p) const {
    const std::uint32_t m = kReturnMap8[(p.returns >> 3) & 7u][p.returns & 7u];
    return (p.returns != last_.returns ? kReturns : 0u) | (p.intensity != last_intensity_[m] ? kIntensity : 0u) |
           (p.classification != last_.classification ? kClass : 0u) | (p.angle != last_.angle ? kAngle : 0u) |
           (p.user != last_.user ? kUser : 0u) | (p.source != last_.source ? kSource : 0u);
  }

  // p may be last_: each value is read before it is written.
  void code_values(Coder& coder, Point10& p, std::uint32_t changed) {
    if (changed & kReturns) p.returns = byte(coder, returns_[last_.returns], p.returns);
    const std::uint32_t r = p.returns & 7u, n = (p.returns >> 3) & 7u;
    const std::uint32_t m = kReturnMap8[n][r];
    code_intensity(coder, p, changed, m);
    if (changed & ~(kReturns | kIntensity)) code_attributes(coder, p, changed);
    code_coordinates(coder, p, m, n, r);
  }

  void code_intensity(Coder& coder, Point10& p, std::uint32_t changed, std::uint32_t m) {
    std::uint16_t& last = last_intensity_[m];
    if (changed & kIntensity) {
      last = static_cast<std::uint16_t>(intensity_.code(coder, last, p.intensity, std::min(m, 3u)));
    }
    p.intensity = last;
  }

  void code_attributes(Coder& coder, Point10& p, std::uint32_t changed) {
    if (changed & kClass) {
      p.classification = byte(coder, classification_[last_.classification], p.classification);
    }
    if (changed & kAngle) {
      const std::uint32_t direction = (p.returns >> 6) & 1u;
      const std::uint32_t step = coder.symbol(angle_[direction], (p.angle - last_.angle) & 255u);
      p.angle = static_cast<std::uint8_t>(last_.angle + step);
    }
    if (changed & kUser) p.user = byte(coder, user_[last_.user], p.user);
    if (changed & kSource) p.source = static_cast<std::uint16_t>(source_.code(coder, last_.source, p.source, 0));
  }

  void code_coordinates(Coder& coder, Point10& p, std::uint32_t m, std::uint32_t n, std::uint32_t r) {
    const std::uint32_t single = n == 1;
    p.x = code_step(coder, x_, x_steps_[m], last_.x, p.x, single);
    p.y = code_step(coder, y_, y_steps_[m], last_.y, p.y, single + y_context(x_.last_bits()));
    const std::uint32_t bits = (x_.last_bits() + y_.last_bits()) / 2;
    std::int32_t& last_z = last_z_[n > r ? n - r : r - n];
    last_z = p.z = z_.code(coder, last_z, p.z, single + z_context(bits));
  }

  Point10 last_;
  std::uint16_t last_intensity_[16];
  std::int32_t last_z_[8];
  Median5 x_steps_[16], y_steps_[16];
  typename Coder::template Model<64> changed_;
  IntegerCodec<Coder, 16, 4> intensity_;
  IntegerCodec<Coder, 16, 1> source_;
  IntegerCodec<Coder, 32, 2> x_;
  IntegerCodec<Coder, 32, 22> y_;
  IntegerCodec<Coder, 32, 20> z_;
  ByteModel angle_[2];
  ByteModel returns_[256], classification_[256], user_[256];
};

}  // namespace ilot::laz
