// SPDX-License-Identifier: Apache-2.0
#include "engine/model/stated_errors.h"

#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {

double seen_error_95(const Facade& facade) {
  std::vector<double> errors;
  for (const FacadeElement& e : facade.elements)
    for (const FacadeEdge& edge : e.edges)
      if (edge.status == DrawnStatus::seen && edge.error_m > 0) errors.push_back(edge.error_m);
  return errors.empty() ? 0 : nth_smallest(errors, (errors.size() * 95 + 99) / 100 - 1);
}

}  // namespace ilot
