// SPDX-License-Identifier: Apache-2.0
#include "engine/model/outline_area.h"

#include "kernels/geometry/ring.h"

namespace ilot {
double area_of(const Outline& outline) {
  double area = 0;
  for (const Outline::Part& part : outline.parts)
    for (std::size_t r = 0; r < part.size(); ++r) area += (r == 0 ? 0.5 : -0.5) * norm(doubled_area(part[r]));
  return area;
}

}  // namespace ilot
