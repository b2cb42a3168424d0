// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "tests/support/plane_sets.h"

namespace ilot::test {

// The Delaunay triangulation by another library, ties as it likes; none where it was not built in.
std::optional<std::vector<PlacedTriangle>> peer_triangles(const std::vector<Point2>& points);

}  // namespace ilot::test
