// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/pixel_order.h"

#include <algorithm>
#include <bit>

namespace ilot {
namespace {

constexpr int kMostDigitBits = 16;

// One stable pass by a digit of the depth of a pixel below the top.
void sort_by_digit(const Image& image, Height top, int shift, int bits, const std::vector<std::uint32_t>& from,
                   std::vector<std::uint32_t>& to) {
  const std::uint32_t digits = 1u << bits;
  const auto digit = [&](std::uint32_t i) {
    const auto depth = static_cast<std::uint32_t>(top) - static_cast<std::uint32_t>(image.values[i]);
    return depth >> shift & (digits - 1);
  };
  std::vector<std::uint32_t> at(std::size_t{digits} + 1, 0);
  for (const std::uint32_t i : from) ++at[digit(i) + 1];
  for (std::uint32_t d = 1; d <= digits; ++d) at[d] += at[d - 1];
  for (const std::uint32_t i : from) to[at[digit(i)]++] = i;
}

}  // namespace

std::vector<std::uint32_t> pixels_from_the_top(const Image& image) {
  std::vector<std::uint32_t> order;
  order.reserve(image.size());
  Height top = kNoHeight, low = kAboveAll;
  for (std::size_t i = 0; i < image.size(); ++i) {
    const Height v = image.values[i];
    if (v == kNoHeight) continue;
    order.push_back(static_cast<std::uint32_t>(i));
    top = std::max(top, v);
    low = std::min(low, v);
  }
  if (order.empty()) return order;
  const int bits = std::bit_width(static_cast<std::uint32_t>(top) - static_cast<std::uint32_t>(low));
  std::vector<std::uint32_t> scratch(order.size());
  const int passes = (bits + kMostDigitBits - 1) / kMostDigitBits;
  for (int pass = 0; pass < passes; ++pass) {
    const int digit_bits = (bits + passes - 1) / passes;
    sort_by_digit(image, top, pass * digit_bits, digit_bits, order, scratch);
    order.swap(scratch);
  }
  return order;
}

}  // namespace ilot
