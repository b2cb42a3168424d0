// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/survey/point_map.h"

#include <cmath>

#include "engine/store/lattice.h"

namespace ilot {
namespace {

// Choice: smaller than the halo of any product, so that the estimate of points is not far off.
constexpr double kSquareMetres = 16;  // greatest side of a square in which points are counted

}  // namespace

int square_bits(double step_metres) {
  int bits = 0;
  while (bits < kTileBits && std::ldexp(step_metres, bits + 1) <= kSquareMetres) ++bits;
  return bits;
}

void PointMap::add(PlanSquare square, std::uint64_t points) {
  squares_[square] += points;
  shrink();
}

void PointMap::add(const PointMap& other) {
  if (bits_ < other.bits_) coarsen_to(other.bits_);
  for (const auto& [square, points] : other.squares_) {
    const int by = bits_ - other.bits_;  // grows where there are too many squares
    squares_[{square.first >> by, square.second >> by}] += points;
    shrink();
  }
}

void PointMap::shrink() {
  while (squares_.size() > kMostSquares) coarsen_to(bits_ + 1);
}

void PointMap::coarsen_to(int bits) {
  const int by = bits - bits_;
  std::map<PlanSquare, std::uint64_t> coarse;
  for (const auto& [square, points] : squares_) coarse[{square.first >> by, square.second >> by}] += points;
  squares_ = std::move(coarse);
  bits_ = bits;
}

std::uint64_t PointMap::in(const IndexBox& box) const {
  if (box.is_empty()) return 0;
  std::uint64_t points = 0;
  for (std::int64_t row = box.min.y >> bits_; row <= box.max.y >> bits_; ++row) {
    auto it = squares_.lower_bound({row, box.min.x >> bits_});
    for (; it != squares_.end() && it->first <= PlanSquare{row, box.max.x >> bits_}; ++it) points += it->second;
  }
  return points;
}

}  // namespace ilot
