// SPDX-License-Identifier: Apache-2.0
// Spheres, cylinders and cones of one cell, as they are kept on disk before the join over cells.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/cells.h"
#include "kernels/shapes/shape_ransac.h"

namespace ilot {

// Lengths in lattice units, coordinates relative to the cell's corner.
struct CellShape {
  Shape shape;  // fitted over the cell and its margin
  double epsilon = 0;
  std::int64_t connectivity = 1;
  std::array<std::int32_t, 3> min{}, max{};  // box of its points in the cell itself
  std::uint32_t points = 0;                  // of these
  std::uint32_t first_sample = 0, samples = 0;
};

struct CellShapes {
  std::vector<CellShape> shapes;
  std::vector<std::array<std::int32_t, 3>>
      samples;                        // of each shape at most kShapeSamples, evenly spread in their order
  std::vector<std::uint32_t> labels;  // per point of the cell, in order: 0 = none, else 1 + index; empty without shapes
};
constexpr std::uint32_t kShapeSamples = 512;

// Keeps the shapes that have points in the cell itself.
void write_cell_shapes(const Store& store, const Cell& cell, const CellPoints& points, const ShapeSegments& found,
                       const PlaneParams& params);

// The shapes of one cell, with or without the labels of its points. Nothing where none was written.
enum class CellPart : std::uint8_t { shapes, labels };
CellShapes read_cell_shapes(const Store& store, const Cell& cell, CellPart part);

}  // namespace ilot
