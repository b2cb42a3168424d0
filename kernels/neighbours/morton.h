// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

constexpr int kMortonBits = 21;  // per axis; a code has 63 bits

namespace detail {
constexpr std::uint64_t spread3(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x001f00000000ffffull;
  v = (v | v << 16) & 0x001f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}
constexpr std::uint32_t gather3(std::uint64_t v) {
  v &= 0x1249249249249249ull;
  v = (v | v >> 2) & 0x10c30c30c30c30c3ull;
  v = (v | v >> 4) & 0x100f00f00f00f00full;
  v = (v | v >> 8) & 0x001f0000ff0000ffull;
  v = (v | v >> 16) & 0x001f00000000ffffull;
  return static_cast<std::uint32_t>((v | v >> 32) & 0x1fffff);
}
}  // namespace detail

struct Cell3 {
  std::uint32_t x = 0, y = 0, z = 0;  // each below 2^21
  friend bool operator==(const Cell3&, const Cell3&) = default;
};

// Bit i of x, y, z becomes bit 3i, 3i+1, 3i+2 of the code.
constexpr std::uint64_t morton_code(Cell3 c) {
  return detail::spread3(c.x) | detail::spread3(c.y) << 1 | detail::spread3(c.z) << 2;
}
constexpr Cell3 morton_cell(std::uint64_t code) {
  return {detail::gather3(code), detail::gather3(code >> 1), detail::gather3(code >> 2)};
}

}  // namespace ilot
