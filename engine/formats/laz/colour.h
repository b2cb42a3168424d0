// SPDX-License-Identifier: Apache-2.0
// Colours: red is coded by the differences of its bytes to the last point; green and blue are corrected by the change
// of red.
#pragma once
#include <cstdint>

#include "engine/formats/laz/arithmetic.h"
#include "engine/formats/laz/predict.h"

namespace ilot::laz {

struct Rgb {
  std::uint16_t r, g, b;
};

template <class Coder>
class RgbCodec {
 public:
  // Encodes `value` relative to the last colour, or decodes it. Returns 0 when nothing changed.
  std::uint32_t code(Coder& coder, const Rgb& last, Rgb& value) {
    if constexpr (!Coder::kEncodes) value = last;
    const std::uint32_t used = coder.symbol(used_, Coder::kEncodes ? changes(last, value) : 0);
    if (used == 0) return 0;
    Bytes v(value);
    const Bytes before(last);
    if (used & 1) v.r[0] = difference(coder, 0, before.r[0], v.r[0]);
    if (used & 2) v.r[1] = difference(coder, 1, before.r[1], v.r[1]);
    if (used & kNotGrey) {
      code_half(coder, used >> 2, 0, before, v);
      code_half(coder, used >> 3, 1, before, v);
      value = {join(v.r), join(v.g), join(v.b)};
    } else {
      value.r = value.g = value.b = join(v.r);
    }
    return used;
  }

 private:
  static constexpr std::uint32_t kNotGrey = 64;
  struct Bytes {
    explicit Bytes(const Rgb& c) : r{c.r & 255, c.r >> 8}, g{c.g & 255, c.g >> 8}, b{c.b & 255, c.b >> 8} {}
    std::int32_t r[2], g[2], b[2];  // low, high
  };

  static std::uint16_t join(const std::int32_t (&v)[2]) { return static_cast<std::uint16_t>(v[0] | v[1] << 8); }

  static std::uint32_t changes(const Rgb& last, const Rgb& v) {
    const auto halves = [](std::uint32_t a, std::uint32_t b) {
      return ((a ^ b) & 0xFF ? 1u : 0u) | ((a ^ b) >> 8 ? 2u : 0u);
    };
    return halves(last.r, v.r) | halves(last.g, v.g) << 2 | halves(last.b, v.b) << 4 |
           (v.g != v.r || v.b != v.r ? kNotGrey : 0u);
  }

  std::int32_t difference(Coder& coder, std::uint32_t model, std::int32_t predicted, std::int32_t real) {
    const auto d = coder.symbol(bytes_[model], static_cast<std::uint32_t>(real - predicted) & 255u);
    return (static_cast<std::int32_t>(d) + predicted) & 255;
  }

  // Codes the low (0) or high (1) bytes of green, then blue. In `changed`, bit 0 is green and bit 2 is blue.
  void code_half(Coder& coder, std::uint32_t changed, std::uint32_t half, const Bytes& last, Bytes& v) {
    const std::int32_t red = v.r[half] - last.r[half];
    if (changed & 1) v.g[half] = difference(coder, 2 + half, clamp_byte(red + last.g[half]), v.g[half]);
    if (changed & 4) {
      const std::int32_t mean = (red + v.g[half] - last.g[half]) / 2;
      v.b[half] = difference(coder, 4 + half, clamp_byte(mean + last.b[half]), v.b[half]);
    }
  }

  typename Coder::template Model<128> used_;
  typename Coder::template Model<256> bytes_[6];
};

template <class Coder>
class NirCodec {
 public:
  // The same as RgbCodec::code.
  std::uint32_t code(Coder& coder, std::uint16_t last, std::uint16_t& value) {
    if constexpr (!Coder::kEncodes) value = last;
    const std::uint32_t difference = last ^ value;
    const std::uint32_t changes = (difference & 0xFF ? 1u : 0u) | (difference >> 8 ? 2u : 0u);
    const std::uint32_t used = coder.symbol(used_, changes);
    std::uint32_t low = value & 0xFFu, high = value >> 8;
    if (used & 1) low = byte(coder, 0, last & 0xFFu, low);
    if (used & 2) high = byte(coder, 1, last >> 8, high);
    value = static_cast<std::uint16_t>(high << 8 | low);
    return used;
  }

 private:
  std::uint32_t byte(Coder& coder, std::uint32_t model, std::uint32_t last, std::uint32_t value) {
    return (last + coder.symbol(bytes_[model], (value - last) & 255u)) & 255u;
  }

  typename Coder::template Model<4> used_;
  typename Coder::template Model<256> bytes_[2];
};

}  // namespace ilot::laz
