// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>

namespace ilot {

// Vectors of a machine with radial kernels, and what they weigh in each of some sums.
struct RadialVectors {
  std::size_t dimensions = 0, sums = 0;
  double gamma = 1;
  std::span<const double> vectors;  // dimensions each
  std::span<const double> weights;  // sums each
};

// Of each row (dimensions each) all the sums of weight exp(-gamma d^2) over the vectors, d the distance from the row to
// the vector, and the greatest of these exponentials (0 without vectors). `totals` has sums for each row and `nearest`
// one; both are overwritten. The exponential is plain arithmetic (relative error below 1e-14; e^-700 below that), terms
// are added vector by vector: same bits for every instruction set, and whatever rows stand beside. Rows with values
// that are not numbers have sums that are none. O(rows vectors (dimensions + sums)).
void radial_sums(const RadialVectors& model, std::span<const double> rows, std::span<double> totals,
                 std::span<double> nearest);

}  // namespace ilot
