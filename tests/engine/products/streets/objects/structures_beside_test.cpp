// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/structures_beside.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/memory_layers.h"

namespace ilot {
namespace {

constexpr std::uint32_t kCellsAcross = 40, kCellsUp = 30;
constexpr double kCellSide = 0.4;  // metres of a cell

Image beside_of(const Image& structure, std::uint32_t tile_side) {
  test::MemoryLayers memory({kCellsAcross, kCellsUp, tile_side});
  memory.put("structure", structure);
  const Cells cells{1, {0.001, kCellSide}, memory.layers};
  for (std::size_t tile = 0; tile < memory.layers.grid.count(); ++tile)
    memory.layers.write("beside", tile, structures_beside(cells, tile));
  return memory.whole("beside");
}

// Every distance is the least over all cells of buildings, and tiles do not matter.
TEST(StructuresBeside, DistancesAreThoseOfAllPairsForEveryTiling) {
  Image structure = filled_image(kCellsAcross, kCellsUp, 0);
  const auto put = [&](std::size_t x, std::size_t y, Structure s) {
    structure.values[y * kCellsAcross + x] = static_cast<Height>(s);
  };
  put(3, 4, Structure::wall), put(17, 15, Structure::roof), put(31, 16, Structure::wall);
  put(10, 20, Structure::crown), put(33, 2, Structure::overhang), put(20, 4, Structure::eaves);
  for (const std::uint32_t side : {10u, 40u}) {
    const Image beside = beside_of(structure, side);
    for (std::size_t i = 0; i < structure.size(); ++i) {
      double least = kBesideReach;
      for (std::size_t j = 0; j < structure.size(); ++j) {
        const auto s = static_cast<Structure>(structure.values[j]);
        if (s != Structure::wall && s != Structure::roof) continue;
        least = std::min(
            least,
            kCellSide * std::hypot(static_cast<double>(i % kCellsAcross) - static_cast<double>(j % kCellsAcross),
                                   static_cast<double>(i / kCellsAcross) - static_cast<double>(j / kCellsAcross)));
      }
      const StructuresBeside found(beside.values[i]);
      EXPECT_NEAR(found.distance(), least, 0.005 + 1e-9) << i;
      const auto own = static_cast<Structure>(structure.values[i]);
      EXPECT_EQ(found.structure(), own == Structure::eaves ? Structure::overhang : own);
    }
  }
}

}  // namespace
}  // namespace ilot
