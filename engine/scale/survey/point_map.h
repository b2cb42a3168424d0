// SPDX-License-Identifier: Apache-2.0
// How many points lie where, over the whole extent of a plan.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "kernels/geometry/box3.h"

namespace ilot {

using PlanSquare = std::pair<std::int64_t, std::int64_t>;  // row, column: y and x, shifted by the bits of the map

// Choice: with 64 bytes each they take 64 MiB.
constexpr std::size_t kMostSquares = std::size_t{1} << 20;

// The side of the squares before any doubling, as bits of lattice steps: 16 m at most.
int square_bits(double step_metres);

// Counts of points by squares. Where more than kMostSquares have points, squares of twice the side are counted. The
// result depends only on the points, not on their order or on the parts in which they were counted.
class PointMap {
 public:
  explicit PointMap(int bits) : bits_(bits) {}

  void add(PlanSquare square, std::uint64_t points);  // square of the bits of this map
  void add(const PointMap& other);

  int bits() const { return bits_; }  // the side of a square is 2^bits lattice steps
  const std::map<PlanSquare, std::uint64_t>& squares() const { return squares_; }
  std::uint64_t in(const IndexBox& box) const;  // points in all squares that meet the box

 private:
  void coarsen_to(int bits);
  void shrink();

  int bits_;
  std::map<PlanSquare, std::uint64_t> squares_;
};

}  // namespace ilot
