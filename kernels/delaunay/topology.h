// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

enum class TopologyFault {
  kNone,
  kArrays,       // sizes that do not fit together, or an index out of range
  kTwins,        // a twin whose twin is another edge, or that joins other points
  kOrientation,  // a triangle that does not turn left
  kHull,         // hull edges that are not one closed line, or that turn right
  kVertices,     // a point missing, or triangles that overlap
};

// Checks whether this is a triangulation of all the points. Every triangle turns left, neighbours agree, the hull is
// one closed convex line, and every point except the duplicates is a corner. The number of triangles agrees with
// Euler's formula, so none overlap. The check is valid for any triangulation, Delaunay or constrained. No triangles are
// correct when all points are on a line. O(n).
TopologyFault check_topology(const Triangulation& t, std::span<const Point2> points);

// Whether no far corner of a neighbour is in the circle of a triangle, as in_circle() decides. Together with a correct
// topology this proves the Delaunay triangulation. O(n).
bool is_delaunay(const Triangulation& t, std::span<const Point2> points);

// Returns the corner of the neighbouring triangle that e does not touch. twin[e] must not be kNoEdge.
inline std::uint32_t far_corner(const Triangulation& t, std::uint32_t e) {
  return t.corner[previous_edge(t.twin[e])];
}

// Returns the hull edge that follows hull edge e, counter-clockwise. O(edges around the point between them).
inline std::uint32_t next_hull_edge(const Triangulation& t, std::uint32_t e) {
  std::uint32_t f = next_edge(e);
  while (t.twin[f] != kNoEdge) f = next_edge(t.twin[f]);
  return f;
}

}  // namespace ilot
