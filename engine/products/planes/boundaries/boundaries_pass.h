// SPDX-License-Identifier: Apache-2.0
// Where segments end: alpha shapes of their points on their planes, made block by block and joined without a seam.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/model/outline.h"
#include "engine/pass/context.h"
#include "engine/products/planes/cells/block_cells.h"
#include "engine/products/planes/join/join_pass.h"
#include "engine/settings/settings.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {

// How far points of a stretch of a block look for their neighbours, in lattice units: twice the connectivity of their
// cell.
struct NeighbourRange {
  std::uint32_t first = 0, count = 0;  // points of the block
  std::int64_t farthest = 1;
};

// Per block, ascending, covering it.
std::vector<std::vector<NeighbourRange>> neighbour_ranges(const Store& store, const std::vector<Cell>& cells,
                                                          const CellPlanes& cell_planes);

struct BoundaryParams {
  double gamma = 1;                     // threshold of a point over the sampling step around it [Lorraine thesis, 3.3]
  double tolerance = 0;                 // lattice units; outlines are thinned to within it
  std::span<const JoinedPlane> planes;  // by final id - 1
  std::span<const std::uint32_t> final_id;
  std::span<const std::vector<NeighbourRange>> ranges;
  std::span<const Scanner> stations =
      {};                // in lattice units; where one sees a point they tell the step, else neighbours
  double threshold = 0;  // lattice units; above 0 that of all points
  TriangleRule rule = TriangleRule::kCircumradius;
  EdgeLength edge_length = EdgeLength::plane;  // of kLongestEdge
  Erosion erosion = Erosion::everywhere;
};

// Gives the outline of every plane to `take`, by id, and writes the column "boundary" (u8: 1 = the point, or one at the
// same place, is a vertex of its plane's outline before thinning). A triangle belongs to a segment when its
// circumradius (or longest edge) is at most the largest threshold of its corners: those of the Delaunay triangulation
// of all points of the segment, whatever the blocks. Eroded from outside only, outlines have no holes and nothing in
// them. Memory: stretches of at most 2^18 points with what lies around them, one a thread, the edges of some planes at
// a time, and a bit a point.
void boundaries_pass(const Store& store, const BoundaryParams& params, const PassContext& context,
                     const std::function<void(Outline)>& take);

}  // namespace ilot
