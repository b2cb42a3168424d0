// SPDX-License-Identifier: Apache-2.0
// Predictors and tables that the point codecs share.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

namespace ilot::laz {

// A running median of the last values. It keeps five sorted values. Each new value replaces the largest or the smallest
// one, alternating with the side on which it lies. It has no branches that depend on the values.
class Median5 {
 public:
  std::int32_t get() const { return v_[2]; }
  void add(std::int32_t x) {
    const std::int32_t* kept = v_ + low_;
    const std::int32_t a = kept[0], b = kept[1], c = kept[2], d = kept[3];
    const std::uint32_t below = x < v_[2], above = v_[2] < x;
    low_ = (low_ & above) | (~low_ & ~below & 1u);
    v_[0] = smaller(a, x);
    v_[1] = larger(a, smaller(b, x));
    v_[2] = larger(b, smaller(c, x));
    v_[3] = larger(c, smaller(d, x));
    v_[4] = larger(d, x);
  }

 private:
  // The same as std::min and std::max, for which compilers generate branches.
  static std::int32_t smaller(std::int32_t a, std::int32_t b) { return b ^ ((a ^ b) & -(a < b)); }
  static std::int32_t larger(std::int32_t a, std::int32_t b) { return a ^ ((a ^ b) & -(a < b)); }

  std::int32_t v_[5] = {};
  std::uint32_t low_ = 0;  // 1: the next value replaces the smallest
};

// Codes a value as its step from the last one, predicted by the median of the last steps. Returns the value.
template <class Coder, class Codec>
std::int32_t code_step(Coder& coder, Codec& codec, Median5& steps, std::int32_t last, std::int32_t value,
                       std::uint32_t context) {
  const std::uint32_t real = static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(last);
  const std::int32_t d = codec.code(coder, steps.get(), static_cast<std::int32_t>(real), context);
  steps.add(d);
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(last) + static_cast<std::uint32_t>(d));
}

constexpr std::int32_t clamp_byte(std::int32_t v) {
  return std::clamp(v, 0, 255);
}

// Contexts that group the number of bits of the coordinates coded before.
constexpr std::uint32_t y_context(std::uint32_t x_bits) {
  return x_bits < 20 ? x_bits & ~1u : 20;
}
constexpr std::uint32_t z_context(std::uint32_t mean_bits) {
  return mean_bits < 18 ? mean_bits & ~1u : 18;
}

// Point formats 0-5: [number of returns][return number].
inline constexpr std::array<std::array<std::uint8_t, 8>, 8> kReturnMap8{{{15, 14, 13, 12, 11, 10, 9, 8},
                                                                         {14, 0, 1, 3, 6, 10, 10, 9},
                                                                         {13, 1, 2, 4, 7, 11, 11, 10},
                                                                         {12, 3, 4, 5, 8, 12, 12, 11},
                                                                         {11, 6, 7, 8, 9, 13, 13, 12},
                                                                         {10, 10, 11, 12, 13, 14, 14, 13},
                                                                         {9, 10, 11, 12, 13, 14, 15, 14},
                                                                         {8, 9, 10, 11, 12, 13, 14, 15}}};

// Point formats 6-10: [number of returns][return number].
inline constexpr std::array<std::array<std::uint8_t, 16>, 16> kReturnMap16{{
    {0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5},
    {1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3},
    {2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3},
    {3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4},
    {4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4},
    {5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4},
    {5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5},
}};

}  // namespace ilot::laz
