// SPDX-License-Identifier: Apache-2.0
// The boundary of a set of triangles as polygons with holes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

// An edge that belongs to one triangle of its region, which lies on its left. A region: triangles of one label, joined
// over edges.
struct BoundaryEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t region = 0;
  friend bool operator==(const BoundaryEdge&, const BoundaryEdge&) = default;
};

// Boundary of the triangles of a triangulation whose label is not 0; edges between two labels count for both. O(n).
std::vector<BoundaryEdge> boundary_edges(const Triangulation& t, std::span<const std::uint8_t> label);

// The same for triangles given by their corners alone, three each, turning left: those that blocks bring together.
// O(n log n).
std::vector<BoundaryEdge> boundary_edges(std::span<const std::uint32_t> corner);

struct Ring {
  std::uint32_t first = 0, count = 0;  // its vertices in Polygons::vertices; from the last an edge leads to the first
  std::uint32_t polygon = 0;
  friend bool operator==(const Ring&, const Ring&) = default;
};

// Polygons one after the other, each its outer ring first, counter-clockwise, then its holes, clockwise.
struct Polygons {
  std::vector<std::uint32_t> vertices;
  std::vector<Ring> rings;
  std::uint32_t count = 0;
};

// Every edge in exactly one closed ring that passes no vertex twice. Where a region touches itself in a vertex the ring
// stays with the fan of triangles it came along, and loops are cut off there: so rings touch, but never cross, and the
// inside of each polygon is connected; a polygon has one outer ring. A polygon is a region: its holes are known without
// looking for them. Each ring starts at its smallest vertex in (x, y), polygons are in the order of theirs, and so are
// holes: the answer depends on the set of edges alone. `edges` must bound regions of triangles: as many edges enter a
// vertex as leave it, per region; other edges give some set of rings. O(n log n).
Polygons assemble_rings(std::span<const BoundaryEdge> edges, std::span<const Point2> points);

// What the outside sees of polygons that do not cross: their outer rings without the holes, and without those that lie
// in another. O(polygons vertices) at worst, O(n log n) where few boxes overlap.
Polygons outer_rings(const Polygons& polygons, std::span<const Point2> points);

// Twice the signed area of a ring: positive when counter-clockwise.
std::int64_t twice_area(const Polygons& polygons, const Ring& ring, std::span<const Point2> points);

}  // namespace ilot
