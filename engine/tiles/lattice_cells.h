// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

// Computes which cell contains a coordinate, counted from the corner of the first cell. The cells lie side by side and
// are `units` lattice units wide. It multiplies for each point and does not divide. Half a unit is added, so that the
// true quotient is at least half a unit away from any whole number, which is more than the error of the product. The
// result is exact for 0 <= v < 2^50.
class LatticeCells {
 public:
  explicit LatticeCells(std::int64_t units) : per_unit_(1 / static_cast<double>(units)) {}

  std::uint32_t operator()(std::int64_t v) const {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>((static_cast<double>(v) + 0.5) * per_unit_));
  }

 private:
  double per_unit_;
};

}  // namespace ilot
