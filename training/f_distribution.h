// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

// Returns the probability that an F-distributed number with d1 and d2 (>= 1) degrees of freedom is at least f. It is 1
// for f <= 0. The function uses the regularised incomplete beta function by its continued fraction (Lentz), in portable
// arithmetic, because it decides which features are selected. The relative error is below 1e-10 for degrees up to 4,000
// where the result is above 1e-290. O(d1 + d2 + sqrt of them).
double f_upper_tail(double f, std::uint32_t d1, std::uint32_t d2);

}  // namespace ilot
