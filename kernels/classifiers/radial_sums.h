// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>

namespace ilot {

// The vectors of a classifier with radial kernels, and the weight of each vector in each of the sums.
struct RadialVectors {
  std::size_t dimensions = 0, sums = 0;
  double gamma = 1;
  std::span<const double> vectors;  // `dimensions` values each
  std::span<const double> weights;  // `sums` values each
};

// Computes for each row (with `dimensions` values) all the sums of weight exp(-gamma d^2) over the vectors, where d is
// the distance from the row to the vector. It also gives the greatest of these exponentials, 0 without vectors.
// `totals` has `sums` values for each row and `nearest` has one. Both are overwritten. The exponential is plain
// arithmetic with a relative error below 1e-14, and e^-700 for smaller values. Terms are added vector by vector. So the
// bits are the same for every instruction set and do not depend on the other rows. The sums of a row are NaN where a
// value of the row is NaN. O(rows vectors (dimensions + sums)).
void radial_sums(const RadialVectors& model, std::span<const double> rows, std::span<double> totals,
                 std::span<double> nearest);

}  // namespace ilot
