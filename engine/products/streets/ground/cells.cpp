// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/cells.h"

namespace ilot {
namespace {

constexpr std::uint32_t kMostPixels = 64;  // along the side of a cell

}  // namespace

Cells cells_of(const TileLayers& layers, const RasterScale& scale, double density) {
  Cells cells;
  cells.factor = 1;
  const auto large_enough = [&](double side) {
    return side >= kLeastCell && density * side * side >= kLeastPointsOfCell;
  };
  while (cells.factor < kMostPixels && layers.grid.side % (2 * cells.factor) == 0 &&
         !large_enough(cells.factor * scale.pixel))
    cells.factor *= 2;
  cells.scale = scale;
  cells.scale.pixel = cells.factor * scale.pixel;
  cells.layers = layers;
  cells.layers.grid.width /= cells.factor;
  cells.layers.grid.height /= cells.factor;
  cells.layers.grid.side /= cells.factor;
  return cells;
}

}  // namespace ilot
