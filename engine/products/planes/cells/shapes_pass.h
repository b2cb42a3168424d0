// SPDX-License-Identifier: Apache-2.0
// Spheres, cylinders and cones over all cells, and the points that lie on them.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/planes/cells/cell_shapes.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// Lengths in lattice units, coordinates relative to `anchor`.
struct JoinedShape {
  Index3 anchor;  // corner of its first cell
  Shape shape;
  double epsilon = 0;
};

struct JoinedShapes {
  std::vector<JoinedShape> shapes;        // by their first cell, so in global order
  std::vector<std::uint32_t> of_segment;  // per shape of a cell, one cell after the other: 1 + index into shapes
  std::vector<std::uint32_t> first;       // per cell: its first shape among these; and their number
};

// Joins shapes of one kind from different cells whose boxes come within the connectivity of each other, those with the
// most points first (ties by index): two groups become one when a shape fitted to samples of both stays within half of
// its epsilon of each (root mean square). Depends on the cells alone. O(n log n) and a fit for each pair that is near.
JoinedShapes join_shapes(const Store& store, const std::vector<Cell>& cells);

// A shape and the points that were labelled with it.
struct ShapeTally {
  std::uint64_t points = 0;
  std::uint64_t content_id = 0;      // a function of the set of points, relative to their tiles
  std::uint64_t squared_errors = 0;  // of distances, in kErrorUnit of the square of epsilon
  IndexBox box{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
};
constexpr double kErrorUnit = 0x1p-24;

// Writes the column "shape" (u32 per point: 0 = none, else 1 + index): what the cells found, where the point has no
// plane (column "plane"), is asked for, and lies within epsilon of the joined shape. Tallies by index.
std::vector<ShapeTally> shapes_pass(const Store& store, const std::vector<Cell>& cells, const JoinedShapes& joined,
                                    const PassContext& context);

}  // namespace ilot
