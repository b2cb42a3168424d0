// SPDX-License-Identifier: Apache-2.0
// The boundary of a set of triangles as polygons with holes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

// An edge that belongs to one triangle of its region. The triangle is on its left. A region is the triangles of one
// label that are joined across edges.
struct BoundaryEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t region = 0;
  friend bool operator==(const BoundaryEdge&, const BoundaryEdge&) = default;
};

// Returns the boundary of the triangles of a triangulation whose label is not 0. Edges between two labels count for
// both. O(n).
std::vector<BoundaryEdge> boundary_edges(const Triangulation& t, std::span<const std::uint8_t> label);

// The same for triangles that are given by their corners alone, three each, turning left, as blocks collect them. O(n
// log n).
std::vector<BoundaryEdge> boundary_edges(std::span<const std::uint32_t> corner);

struct Ring {
  std::uint32_t first = 0, count = 0;  // its vertices in Polygons::vertices; an edge leads from the last to the first
  std::uint32_t polygon = 0;
  friend bool operator==(const Ring&, const Ring&) = default;
};

// Polygons one after the other. Each has its outer ring first, counter-clockwise, and then its holes, clockwise.
struct Polygons {
  std::vector<std::uint32_t> vertices;
  std::vector<Ring> rings;
  std::uint32_t count = 0;
};

// Puts every edge into exactly one closed ring that passes no vertex twice. Where a region touches itself in a vertex,
// the ring stays with the fan of triangles along which it came, and loops are cut off there. So rings may touch but
// never cross, the inside of each polygon is connected, and a polygon has one outer ring. A polygon is a region, so no
// search for its holes is needed. Each ring starts at its smallest vertex in (x, y). Polygons are in the order of their
// first vertices, and so are holes. The result depends on the set of edges alone. `edges` must bound regions of
// triangles: for each region as many edges enter a vertex as leave it. Other edges give some set of rings. O(n log n).
Polygons assemble_rings(std::span<const BoundaryEdge> edges, std::span<const Point2> points);

// Returns the outer rings of polygons that do not cross, without the holes and without the rings inside another ring.
// O(polygons vertices) at worst, O(n log n) where few boxes overlap.
Polygons outer_rings(const Polygons& polygons, std::span<const Point2> points);

// Twice the signed area of a ring, positive when it is counter-clockwise.
std::int64_t twice_area(const Polygons& polygons, const Ring& ring, std::span<const Point2> points);

}  // namespace ilot
