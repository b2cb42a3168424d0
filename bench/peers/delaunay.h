// SPDX-License-Identifier: Apache-2.0
// Triangulations and alpha shapes by other libraries; without -DILOT_BENCH_PEERS=ON there are none.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "kernels/delaunay/predicates.h"

namespace ilot::bench {

struct ShapePeer {
  std::string name;
  bool slow = false;  // timed once
  // The number of triangles of the Delaunay triangulation, or of those with a circumradius of at most `reach` > 0.
  std::function<std::size_t(std::span<const Point2>, double reach)> triangles;
};

std::vector<ShapePeer> delaunay_peers();
std::vector<ShapePeer> alpha_shape_peers();

}  // namespace ilot::bench
