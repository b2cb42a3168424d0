// SPDX-License-Identifier: Apache-2.0
// The spheres, cylinders and cones of one cell, as they are stored before the join over cells.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/cells.h"
#include "kernels/shapes/shape_ransac.h"

namespace ilot {

// Lengths are in lattice units, coordinates are relative to the corner of the cell.
struct CellShape {
  Shape shape;  // fitted over the cell and its margin
  double epsilon = 0;
  std::int64_t connectivity = 1;
  std::array<std::int32_t, 3> min{}, max{};  // box of its points in the cell itself
  std::uint32_t points = 0;                  // number of these points
  std::uint32_t first_sample = 0, samples = 0;
};

struct CellShapes {
  std::vector<CellShape> shapes;
  std::vector<std::array<std::int32_t, 3>>
      samples;                        // at most kShapeSamples of each shape, evenly spread in the order of the points
  std::vector<std::uint32_t> labels;  // per point of the cell, in order: 0 = none, else 1 + index; empty without shapes
};
constexpr std::uint32_t kShapeSamples = 512;

// The file in which the shapes of a cell are stored.
std::filesystem::path shapes_path(const Store& store, const Cell& cell);

// Stores the shapes that have points in the cell itself.
void write_cell_shapes(const Store& store, const Cell& cell, const CellPoints& points, const ShapeSegments& found,
                       const PlaneParams& params);

// Reads the shapes of one cell, with or without the labels of its points. The result is empty where none was written.
enum class CellPart : std::uint8_t { shapes, labels };
CellShapes read_cell_shapes(const Store& store, const Cell& cell, CellPart part);

}  // namespace ilot
