// SPDX-License-Identifier: Apache-2.0
// The alpha shapes of one block: what of them its own points own, as edges that the neighbouring blocks' edges
// complete.
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>

#include "engine/products/planes/boundaries/boundary_stretches.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// An edge of a triangle that this block owns, whose other side it does not own or that has none. Another block may give
// the same edge the other way round: then it lies inside.
struct SeamEdge {
  std::uint64_t from = 0, to = 0;  // points, numbered in global order
  Point2 at;                       // of `from`, in the plane's frame
  std::uint32_t region = 0;        // triangles of this block and plane that hang together; dense from 0 within a run
  std::uint32_t plane = 0;         // final id
};

// Both ends, the smaller first: the same for the two edges that two blocks give of one line.
inline std::pair<std::uint64_t, std::uint64_t> ends_of(const SeamEdge& e) {
  return {std::min(e.from, e.to), std::max(e.from, e.to)};
}

// Consecutive edges of one plane, ascending by their ends.
struct SeamRun {
  std::uint32_t plane = 0, first = 0, count = 0;
  std::uint32_t regions = 0;
};

// A point of this block that coincides on its plane with another, which stands for both.
struct Coincident {
  std::uint32_t point = 0;  // of the block
  std::uint64_t kept = 0;   // in global order
};

// Writes "coincident" (Coincident), "seam_runs" (SeamRun) and, in the same order, "seam_edges" (SeamEdge).
void write_seam_edges(const Store& store, std::uint32_t block, const BoundaryWork& work);

}  // namespace ilot
