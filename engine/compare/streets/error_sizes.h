// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

namespace ilot {

// Sizes of errors in metres.
struct ErrorSizes {
  std::uint64_t count = 0;
  double median = 0, p95 = 0;  // not a number without any
};

// The values at ranks ceil(n / 2) and ceil(0.95 n) of the sizes.
ErrorSizes sizes_of(std::vector<double> errors);

}  // namespace ilot
