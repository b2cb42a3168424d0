// SPDX-License-Identifier: Apache-2.0
// Shared by the benches of neighbours: the town, its index, and nanoflann's tree over the same points.
#pragma once
#include <cstdint>
#include <nanoflann.hpp>
#include <numeric>
#include <vector>

#include "bench/surface.h"
#include "kernels/core/parallel.h"

namespace ilot::bench {

inline std::vector<std::uint32_t> all_of(std::size_t n) {
  std::vector<std::uint32_t> v(n);
  std::iota(v.begin(), v.end(), 0u);
  return v;
}

// Runs body(begin, end) over [0, count) in grains, on the threads of the calling arena.
template <class Body>
void in_grains(std::size_t count, const Body& body) {
  constexpr std::size_t kGrain = 1 << 13;
  parallel_for((count + kGrain - 1) / kGrain,
               [&](std::size_t g) { body(g * kGrain, std::min(count, (g + 1) * kGrain)); });
}

struct Adaptor {
  Points p;
  std::size_t kdtree_get_point_count() const { return p.size; }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return axis == 0 ? p.x[i] : axis == 1 ? p.y[i] : p.z[i];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// Computes distances in double: the squares of the coordinates of a town do not fit into float32.
struct PeerTree {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Adaptor, double>, Adaptor, 3,
                                                   std::uint32_t>;
  explicit PeerTree(Points p) : adaptor{p} {}
  Adaptor adaptor;
  Tree tree{3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10)};
};

}  // namespace ilot::bench
