// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "tests/support/plane_sets.h"

namespace ilot::test {

// Returns the Delaunay triangulation by another library, which decides ties in its own way. Returns nothing if the
// library was not built in.
std::optional<std::vector<PlacedTriangle>> peer_triangles(const std::vector<Point2>& points);

}  // namespace ilot::test
