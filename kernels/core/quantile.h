// SPDX-License-Identifier: Apache-2.0
// Order statistics of a vector. Each result is one of the values, and nothing is interpolated. All functions reorder
// the vector, so give a copy where its order matters. They cost O(n). The values must be comparable: no NaN.
#pragma once
#include <algorithm>
#include <cstddef>

namespace ilot {

// Returns the value at position `rank` in sorted order, counted from 0. rank is below the number of values.
template <class Vector>
auto nth_smallest(Vector&& values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Returns the value at rank share * (n - 1), rounded down. Share 0 gives the smallest value and 1 the largest. Of an
// even number of values, 0.5 gives the lower of the two in the middle. There must be at least one value.
template <class Vector>
auto lower_quantile(Vector&& values, double share) {
  return nth_smallest(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

// Returns the value at rank n / 2. Of an even number of values this is the upper of the two in the middle. There must
// be at least one value.
template <class Vector>
auto upper_median(Vector&& values) {
  return nth_smallest(values, values.size() / 2);
}

}  // namespace ilot
