// SPDX-License-Identifier: Apache-2.0
#include "ilot/clusters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/api/lattice_points.h"
#include "engine/error.h"
#include "kernels/neighbours/clusters.h"

namespace ilot {

Clusters euclidean_clusters(const PointArrays& points, double radius, double step) {
  const LatticePoints lattice = lattice_points(points, step);
  const double reach = std::round(in_steps(radius, lattice.step, "radius"));
  if (!(reach >= 1) || reach * 500000 < kLatticeSteps)
    throw Error("radius: too small beside the extent of the points, split them first", ExitCode::usage);
  std::vector<std::uint32_t> all(lattice.given.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[lattice.given[i]] = i;  // in the user's order: so are the numbers
  const double most = kLatticeSteps * 2;
  return euclidean_clusters(lattice.view(), all, static_cast<std::int64_t>(std::min(reach, most)));
}

}  // namespace ilot
