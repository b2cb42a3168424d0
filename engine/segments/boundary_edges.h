// SPDX-License-Identifier: Apache-2.0
// The alpha shapes of one block: what of them its own points own, as edges that the neighbouring blocks' edges
// complete.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/segments/boundaries_pass.h"
#include "engine/store/lattice.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/delaunay/predicates.h"

namespace ilot {

// An edge of a triangle that this block owns, whose other side it does not own or that has none. Another block may give
// the same edge the other way round: then it lies inside.
struct SeamEdge {
  std::uint64_t from = 0, to = 0;  // points, numbered in global order
  Point2 at;                       // of `from`, in the plane's frame
  std::uint32_t region = 0;        // triangles of this block and plane that hang together; dense from 0 within a run
  std::uint32_t plane = 0;         // final id
};

// Consecutive edges of one plane.
struct SeamRun {
  std::uint32_t plane = 0, first = 0, count = 0;
  std::uint32_t regions = 0;
};

// A point of this block that coincides on its plane with another, which stands for both.
struct Coincident {
  std::uint32_t point = 0;  // of the block
  std::uint64_t kept = 0;   // in global order
};

// The points of one octree cell of a block. What happens there belongs to it: the points of a plane whose feet on the
// plane lie in its box, wherever noise has put the points themselves. A plane along the border of two cells would else
// be torn into as many parts as it has points.
struct Stretch {
  Node node;
  std::uint32_t block = 0, first = 0, count = 0;
  IndexBox box;  // what of the cell is near points of the block
};

// What all blocks share.
struct BoundaryWork {
  const BoundaryParams& params;
  std::int64_t across = 0;            // units; most that two points of a plane lie apart across it
  std::vector<std::uint64_t> first;   // per block its first point in global order, and the number of all points
  std::vector<Stretch> stretches;     // in global order
  std::vector<std::size_t> of_block;  // per block its first stretch, and the number of all

  std::span<const Stretch> of(std::uint32_t block) const {
    return std::span(stretches).subspan(of_block[block], of_block[block + 1] - of_block[block]);
  }
};
BoundaryWork boundary_work(const Store& store, const BoundaryParams& params, const PassContext& context);

// Bytes that the work on one block holds.
std::uint64_t boundary_bytes(const Store& store, std::uint32_t block, const BoundaryWork& work);

// Writes "coincident" (Coincident), "seam_runs" (SeamRun) and, in the same order, "seam_edges" (SeamEdge).
void write_seam_edges(const Store& store, std::uint32_t block, const BoundaryWork& work);

// The frame on which a plane's points are triangulated: lattice units, relative to its anchor.
PlaneFrame frame_of_joined(const JoinedPlane& plane);

}  // namespace ilot
