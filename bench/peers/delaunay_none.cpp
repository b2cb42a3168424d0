// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/delaunay.h"

namespace ilot::bench {

std::vector<ShapePeer> delaunay_peers() {
  return {};
}
std::vector<ShapePeer> alpha_shape_peers() {
  return {};
}

}  // namespace ilot::bench
