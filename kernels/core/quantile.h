// SPDX-License-Identifier: Apache-2.0
// Order statistics of a vector. Each answer is one of its values, nothing is interpolated. All of them reorder the
// vector (give a copy where its order matters) and cost O(n). The values must be comparable: no NaN.
#pragma once
#include <algorithm>
#include <cstddef>

namespace ilot {

// The value that stands at `rank` in sorted order, counted from 0; rank is below the number of values.
template <class Vector>
auto nth_smallest(Vector&& values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The value at rank share * (n - 1), rounded down: share 0 gives the smallest value, 1 the largest one, and 0.5 of an
// even number of values the lower one of the two in the middle. At least one value.
template <class Vector>
auto lower_quantile(Vector&& values, double share) {
  return nth_smallest(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

// The value at rank n / 2: of an even number of values the upper one of the two in the middle. At least one value.
template <class Vector>
auto upper_median(Vector&& values) {
  return nth_smallest(values, values.size() / 2);
}

}  // namespace ilot
