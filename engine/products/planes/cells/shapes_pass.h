// SPDX-License-Identifier: Apache-2.0
// Joins spheres, cylinders and cones over all cells, and labels the points that lie on them.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/planes/cells/cell_shapes.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// Lengths are in lattice units, coordinates are relative to `anchor`.
struct JoinedShape {
  Index3 anchor;  // corner of its first cell
  Shape shape;
  double epsilon = 0;
};

struct JoinedShapes {
  std::vector<JoinedShape> shapes;        // ordered by their first cell, so in global order
  std::vector<std::uint32_t> of_segment;  // for each shape of a cell, cell by cell: 1 + index into `shapes`
  std::vector<std::uint32_t> first;       // per cell: its first shape in `of_segment`; then the number of all
};

// Joins shapes of one kind from different cells whose boxes are within the connectivity of each other. Shapes with the
// most points come first (ties by index). Two groups become one if a shape that is fitted to samples of both stays
// within half of its epsilon of each (root mean square). The result depends on the cells alone. O(n log n), and one fit
// for each pair of near shapes.
JoinedShapes join_shapes(const Store& store, const std::vector<Cell>& cells);

// A shape and the points that have its label.
struct ShapeTally {
  std::uint64_t points = 0;
  std::uint64_t content_id = 0;      // a function of the set of points, relative to their tiles
  std::uint64_t squared_errors = 0;  // sum of squared distances, in units of kErrorUnit times the square of epsilon
  IndexBox box{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
};
constexpr double kErrorUnit = 0x1p-24;

// Writes the column "shape" (u32 per point: 0 = none, else 1 + index). A point gets the shape that its cell found if it
// has no plane (column "plane"), is wanted, and lies within epsilon of the joined shape. Returns the tallies by index.
std::vector<ShapeTally> shapes_pass(const Store& store, const std::vector<Cell>& cells, const JoinedShapes& joined,
                                    const PassContext& context);

}  // namespace ilot
