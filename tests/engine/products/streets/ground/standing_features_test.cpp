// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/standing_features.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "kernels/core/rng.h"
#include "tests/support/memory_layers.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

constexpr std::uint32_t kWide = 70, kHigh = 50;
constexpr Height kLeast = 1800;

// Cells of 0.4 m, and what their points give.
struct Scene {
  CellMeasures measures;

  Scene() { measures.fill(filled_image(kWide, kHigh, 0)); }
  Image& of(CellMeasure m) { return measures[static_cast<std::size_t>(m)]; }
  void add(const test::PixelBox& box, Height top, Height upright) {
    test::put(of(CellMeasure::top), box, top);
    test::put(of(CellMeasure::bins), box, (1 << (top / 500 + 1)) - 1);
    test::put(of(CellMeasure::upright), box, upright);
  }
  // The features of each tall cell of the whole image, by its number there.
  std::map<std::size_t, std::vector<double>> rows(std::uint32_t side) const {
    test::MemoryLayers memory({kWide, kHigh, side});
    for (std::size_t m = 0; m < kCellMeasures; ++m)
      memory.put(cell_measure_layer(static_cast<CellMeasure>(m)), measures[m]);
    const Cells cells{4, {0.001, 0.4}, memory.layers};
    std::map<std::size_t, std::vector<double>> out;
    for (std::size_t tile = 0; tile < memory.layers.grid.count(); ++tile) {
      const TileFrame frame = tile_frame(memory.layers.grid, tile);
      const CellMeasures around = cell_measures_around(cells, tile);
      const StandingRows found = standing_rows(around, cells.scale, cells.factor, kLeast);
      for (std::size_t i = 0; i < found.cells.size(); ++i) {
        const std::size_t cell = cell_of_tile(around, found.cells[i]);
        const auto first = found.rows.begin() + static_cast<std::ptrdiff_t>(i * standing_features());
        out[(frame.y + cell / frame.width) * kWide + frame.x + cell % frame.width] = {
            first, first + static_cast<std::ptrdiff_t>(standing_features())};
      }
    }
    return out;
  }
};

double value_of(const std::vector<double>& row, const std::string& name) {
  for (std::size_t f = 0; f < standing_features(); ++f)
    if (standing_feature_name(f) == name) return row[f];
  ADD_FAILURE() << name;
  return 0;
}

TEST(StandingFeatures, NamesAreDifferent) {
  std::set<std::string> names;
  for (std::size_t f = 0; f < standing_features(); ++f) names.insert(standing_feature_name(f));
  EXPECT_EQ(names.size(), standing_features());
}

TEST(StandingFeatures, AWallIsALineAndAPostIsNone) {
  Scene scene;
  scene.add({5, 20, 40, 1}, 9000, 4);
  scene.add({60, 40, 1, 1}, 6000, 1);
  scene.add({50, 5, 1, 1}, 1700, 1);  // not tall
  const auto rows = scene.rows(kWide);
  ASSERT_EQ(rows.size(), 41u);
  const std::vector<double>&wall = rows.at(20 * kWide + 25), &post = rows.at(40 * kWide + 60);
  EXPECT_DOUBLE_EQ(value_of(wall, "top"), 9);
  EXPECT_DOUBLE_EQ(value_of(wall, "upright"), 0.25);
  EXPECT_DOUBLE_EQ(value_of(wall, "upright line cells within 6"), 13);
  EXPECT_DOUBLE_EQ(value_of(wall, "upright line width within 6"), 0);
  EXPECT_DOUBLE_EQ(value_of(wall, "upright line length within 6"), std::sqrt((13.0 * 13 - 1) / 12));
  EXPECT_DOUBLE_EQ(value_of(wall, "tall within 1"), 3.0 / 9);
  EXPECT_DOUBLE_EQ(value_of(post, "upright line cells within 6"), 1);
  EXPECT_DOUBLE_EQ(value_of(post, "higher within 6"), 0);
}

TEST(StandingFeatures, TheTilesDoNotDecide) {
  Scene scene;
  Rng rng(3, 4);
  for (int i = 0; i < 60; ++i)
    scene.add(
        {static_cast<std::uint32_t>(rng.below(kWide - 4)), static_cast<std::uint32_t>(rng.below(kHigh - 4)), 3, 2},
        static_cast<Height>(500 + rng.below(3000)), static_cast<Height>(rng.below(4)));
  const auto want = scene.rows(kWide);
  EXPECT_GT(want.size(), 50u);
  for (const std::uint32_t side : {16u, 37u}) EXPECT_EQ(scene.rows(side), want) << side;
}

}  // namespace
}  // namespace ilot
