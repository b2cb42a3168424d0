// SPDX-License-Identifier: Apache-2.0
// The part of the alpha shapes that belongs to the points of one block. It is stored as edges; the edges of the
// neighbouring blocks complete it.
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>

#include "engine/products/planes/boundaries/boundary_stretches.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// An edge of a triangle of this block, where the triangle on the other side belongs to another block or does not exist.
// If another block gives the same edge in the opposite direction, the edge is not on the outline but inside.
struct SeamEdge {
  std::uint64_t from = 0, to = 0;  // points, by their number in global order
  Point2 at;                       // place of `from`, in the frame of the plane
  std::uint32_t region = 0;        // connected triangles of this block and plane; dense from 0 within a run
  std::uint32_t plane = 0;         // final id
};

// Both ends, the smaller first. The result is the same for the two edges that two blocks give of one line.
inline std::pair<std::uint64_t, std::uint64_t> ends_of(const SeamEdge& e) {
  return {std::min(e.from, e.to), std::max(e.from, e.to)};
}

// Consecutive edges of one plane, in ascending order of their ends.
struct SeamRun {
  std::uint32_t plane = 0, first = 0, count = 0;
  std::uint32_t regions = 0;
};

// A point of this block that coincides on its plane with another point. The other one represents both.
struct Coincident {
  std::uint32_t point = 0;  // number within the block
  std::uint64_t kept = 0;   // number in global order
};

// Writes "coincident" (Coincident), "seam_runs" (SeamRun) and, in the same order, "seam_edges" (SeamEdge).
void write_seam_edges(const Store& store, std::uint32_t block, const BoundaryWork& work);

}  // namespace ilot
