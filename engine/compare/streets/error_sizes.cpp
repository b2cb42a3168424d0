// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/error_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ilot {

ErrorSizes sizes_of(std::vector<double> errors) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  if (errors.empty()) return {0, kNothing, kNothing};
  for (double& e : errors) e = std::abs(e);
  std::sort(errors.begin(), errors.end());
  const auto n = errors.size();
  return {n, errors[(n + 1) / 2 - 1], errors[(19 * n + 19) / 20 - 1]};
}

}  // namespace ilot
