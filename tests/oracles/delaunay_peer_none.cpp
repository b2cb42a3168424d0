// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/delaunay_peer.h"

namespace ilot::test {

std::optional<std::vector<PlacedTriangle>> peer_triangles(const std::vector<Point2>&) {
  return std::nullopt;
}

}  // namespace ilot::test
