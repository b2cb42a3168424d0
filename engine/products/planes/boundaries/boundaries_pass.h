// SPDX-License-Identifier: Apache-2.0
// Finds the outlines of segments: alpha shapes of their points on their planes, made block by block and joined without
// a seam.
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

// The distance at which the points of a stretch of a block look for neighbours, in lattice units: twice the
// connectivity of their cell.
struct NeighbourRange {
  std::uint32_t first = 0, count = 0;  // points of the block
  std::int64_t farthest = 1;
};

// The ranges of each block, in ascending order; they cover the block.
std::vector<std::vector<NeighbourRange>> neighbour_ranges(const Store& store, const std::vector<Cell>& cells,
                                                          const CellPlanes& cell_planes);

struct BoundaryParams {
  double gamma = 1;      // threshold of a point, as a multiple of the sampling step around it [Lorraine thesis, 3.3]
  double tolerance = 0;  // lattice units; outlines are simplified within this distance
  std::span<const JoinedPlane> planes;  // by final id - 1
  std::span<const std::uint32_t> final_id;
  std::span<const std::vector<NeighbourRange>> ranges;
  std::span<const Scanner> stations =
      {};  // in lattice units; where one sees a point it gives the sampling step, otherwise the neighbours do
  double threshold = 0;  // lattice units; above 0: the threshold of all points
  TriangleRule rule = TriangleRule::kCircumradius;
  EdgeLength edge_length = EdgeLength::plane;  // for kLongestEdge
  Erosion erosion = Erosion::everywhere;
};

// Gives the outline of every plane to `take`, in the order of the ids. Writes the column "boundary" (u8: 1 = the point,
// or one at the same place, is a vertex of the outline of its plane before simplification). A triangle of the Delaunay
// triangulation of all points of the segment belongs to the segment if its circumradius (or longest edge) is at most
// the largest threshold of its corners. The result does not depend on the blocks. If erosion is only from outside,
// outlines have no holes and no rings inside. The memory is one stretch per thread, of at most 2^18 points with the
// points around it, the edges of some planes at a time, and one bit per point.
void boundaries_pass(const Store& store, const BoundaryParams& params, const PassContext& context,
                     const std::function<void(Outline)>& take);

}  // namespace ilot
