// SPDX-License-Identifier: Apache-2.0
// Fewer triangles for the same outline [Marchand 2018, II.4.1].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/rings.h"

namespace ilot {

// Removes as many vertices of the rings as can be left out one by one, the least noticeable first. Every vertex left
// out stays less than `tolerance` lattice units from the edge that replaces it, so both lines are within that of each
// other. Rings stay simple, do not cross and keep their orientation and their order. The inside stays on the same side
// of every vertex kept. Vertices where rings touch, or that polygons share, stay. The result depends on the rings
// alone. About O(n log n).
Polygons thin_rings(const Polygons& polygons, std::span<const Point2> points, double tolerance);

// Returns the inside of polygons as triangles whose corners are vertices of the rings, three per triangle, turning
// left. They are the constrained Delaunay triangulation of the polygons. A polygon with n vertices and h holes that
// touch nowhere gives n + 2h - 2 triangles. About O(n log n).
std::vector<std::uint32_t> fill_polygons(const Polygons& polygons, std::span<const Point2> points);

}  // namespace ilot
