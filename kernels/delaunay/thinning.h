// SPDX-License-Identifier: Apache-2.0
// Fewer triangles for the same outline [Marchand 2018, II.4.1].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/rings.h"

namespace ilot {

// The rings with as few of their vertices as one by one can be left out, the least noticeable first: every vertex left
// out stays less than `tolerance` lattice units from the edge in its place, so both lines lie within that of each
// other. Rings stay simple, do not cross and keep their sense and their order, the inside stays on the same side of
// every vertex kept. Vertices where rings touch, or that polygons share, stay. A property of the rings alone. About O(n
// log n).
Polygons thin_rings(const Polygons& polygons, std::span<const Point2> points, double tolerance);

// The inside of polygons as triangles whose corners are vertices of the rings, three a triangle, turning left: their
// constrained Delaunay triangulation. n vertices and h holes that nowhere touch give n + 2h - 2 triangles a polygon.
// About O(n log n).
std::vector<std::uint32_t> fill_polygons(const Polygons& polygons, std::span<const Point2> points);

}  // namespace ilot
