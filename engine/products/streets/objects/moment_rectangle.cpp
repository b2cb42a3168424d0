// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/moment_rectangle.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {

MomentRectangle moment_rectangle(double xx, double xy, double yy, double pixel) {
  const double half = (xx + yy) / 2, root = std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
  const auto side = [&](double variance) { return pixel * std::sqrt(12 * std::max(0.0, variance) + 1); };
  return {side(half + root), side(half - root), direction_degrees((xx - yy) / 2, xy) / 2};
}

}  // namespace ilot
