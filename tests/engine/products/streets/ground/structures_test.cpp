// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/structures.h"

#include <gtest/gtest.h>

#include "engine/products/streets/ground/standing_features.h"
#include "kernels/core/rng.h"
#include "tests/support/memory_layers.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

constexpr std::uint32_t kCellsWide = 100, kCellsHigh = 60;

// A scene of cells of 0.4 m: where forms of what height stand.
struct CellScene {
  Image shape = filled_image(kCellsWide, kCellsHigh, 0), top = filled_image(kCellsWide, kCellsHigh, 0);

  void add(const test::PixelBox& box, StandingForm form, Height height) {
    test::put(shape, box, static_cast<Height>(form));
    test::put(top, box, height);
  }
  Image structure(std::uint32_t side, StreetView view) const {
    test::MemoryLayers memory({kCellsWide, kCellsHigh, side});
    memory.put("shape", shape);
    memory.put("top", top);
    find_structures({1, {0.001, 0.4}, memory.layers}, view);
    return memory.whole("structure");
  }
};

Structure at(const Image& structure, std::size_t x, std::size_t y) {
  return static_cast<Structure>(structure.values[y * kCellsWide + x]);
}

// A scene from the street: what the points of cells of 0.4 m give, in pixels of 10 cm. The ground is seen everywhere.
struct StreetScene {
  Image shape = filled_image(kCellsWide, kCellsHigh, 0);
  CellMeasures measures;

  StreetScene() {
    measures.fill(shape);
    std::fill(of(CellMeasure::bins).values.begin(), of(CellMeasure::bins).values.end(), 1);
    std::fill(of(CellMeasure::pixels).values.begin(), of(CellMeasure::pixels).values.end(), 16);
  }
  Image& of(CellMeasure m) { return measures[static_cast<std::size_t>(m)]; }
  void set(std::size_t i, CellMeasure m, Height v) { of(m).values[i] = v; }
  static Height deviations(double a, double b, double c) {
    const auto steps = [](double sides) { return std::min(1023, static_cast<int>(sides * kDeviationSteps)); };
    return static_cast<Height>(steps(a) | steps(b) << 10 | steps(c) << 20);
  }
  // Nothing is seen there.
  void hide(const test::PixelBox& box) {
    each(box, [&](std::size_t i) {
      set(i, CellMeasure::top, kNoHeight);
      for (const CellMeasure m : {CellMeasure::bins, CellMeasure::pixels}) set(i, m, 0);
    });
  }
  // Upright from the ground up.
  void add_wall(const test::PixelBox& box, Height top) {
    each(box, [&](std::size_t i) {
      shape.values[i] = static_cast<Height>(StandingForm::upright);
      set(i, CellMeasure::top, top);
      set(i, CellMeasure::bins, (1 << (top / 500 + 1)) - 1);
      set(i, CellMeasure::deviations, deviations(0.05, 0.29, top / 400.0 / 3.5));
      set(i, CellMeasure::upright, 4);
      set(i, CellMeasure::most_bins, top / 500 - 1);
    });
  }
  // Leaves from `bottom` up, over ground that is seen.
  void add_crown(const test::PixelBox& box, Height bottom, Height top) {
    Rng rng(5, 6);
    each(box, [&](std::size_t i) {
      const auto own = top - static_cast<Height>(rng.below(1500));
      HeightBins bins = 1;
      for (Height h = bottom; h <= own; h += 500)
        if (rng.below(10) < 7 || h + 500 > own) bins |= 1u << (h / 500);
      shape.values[i] = static_cast<Height>(StandingForm::volume);
      set(i, CellMeasure::top, own);
      set(i, CellMeasure::bins, static_cast<Height>(bins));
      set(i, CellMeasure::deviations, deviations(0.25, 0.3, (own - bottom) / 400.0 / 3.5));
      set(i, CellMeasure::normal, 300);
      set(i, CellMeasure::most_bins, 3);
    });
  }
  Image structure(std::uint32_t side) const {
    test::MemoryLayers memory({kCellsWide, kCellsHigh, side});
    memory.put("shape", shape);
    for (std::size_t m = 0; m < kCellMeasures; ++m)
      memory.put(cell_measure_layer(static_cast<CellMeasure>(m)), measures[m]);
    find_structures({4, {0.001, 0.4}, memory.layers}, StreetView::street);
    return memory.whole("structure");
  }

 private:
  template <class Do>
  static void each(const test::PixelBox& box, const Do& take) {
    for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
      for (std::uint32_t x = box.x; x < box.x + box.width; ++x) take(std::size_t{y} * kCellsWide + x);
  }
};

StreetScene busy_scene() {
  StreetScene scene;
  scene.hide({0, 0, kCellsWide, 8});  // behind the wall
  scene.add_wall({5, 8, 60, 1}, 9000);
  scene.add_crown({20, 25, 12, 12}, 3500, 8000);
  scene.add_wall({50, 30, 1, 1}, 6000);   // a post
  scene.add_wall({60, 48, 12, 1}, 2300);  // the side of a van
  return scene;
}

TEST(Structures, WallsCrownsAndTheRestFromTheStreet) {
  const Image found = busy_scene().structure(60);
  EXPECT_EQ(at(found, 30, 8), Structure::wall);
  EXPECT_EQ(at(found, 26, 31), Structure::crown);
  EXPECT_EQ(at(found, 50, 30), Structure::none);
  EXPECT_EQ(at(found, 66, 48), Structure::none);
  EXPECT_EQ(at(found, 30, 16), Structure::none) << "nothing stands there";
}

// A bench below a balcony: nothing is between 2 and 2.5 m.
TEST(Structures, ABuildingThatIsFreeBelowHangsOver) {
  constexpr HeightBins high = 0x1e0, bench = 0x3;
  EXPECT_EQ(where_free_below(Structure::wall, high | bench), Structure::overhang);
  EXPECT_EQ(where_free_below(Structure::roof, high | bench), Structure::eaves);
  EXPECT_EQ(where_free_below(Structure::roof, high), Structure::roof) << "nothing is seen below";
  EXPECT_EQ(where_free_below(Structure::wall, high | bench | 0x10), Structure::wall);
  EXPECT_EQ(where_free_below(Structure::crown, high | bench), Structure::crown);
  EXPECT_TRUE(is_overhead(Structure::eaves));

  StreetScene scene = busy_scene();
  for (std::size_t x = 25; x < 30; ++x) scene.set(8 * kCellsWide + x, CellMeasure::bins, high | bench);
  const Image found = scene.structure(60);
  EXPECT_EQ(at(found, 27, 8), Structure::overhang);
  EXPECT_EQ(at(found, 35, 8), Structure::wall);
  EXPECT_EQ(scene.structure(20).values, found.values) << "in tiles";
}

// A cloud that is cut at 4 m: what is left of a facade between gaps is longer than a van.
TEST(Structures, AWallThatIsCutLowIsAHouseFromTheStreet) {
  const auto walls_of = [](std::uint32_t cells) {
    StreetScene scene;
    scene.hide({0, 0, kCellsWide, 8});
    for (const std::uint32_t x : {5u, 36u, 67u}) scene.add_wall({x, 8, cells, 1}, 4000);
    return scene.structure(60);
  };
  EXPECT_EQ(at(walls_of(28), 45, 8), Structure::wall) << "11 m";
  EXPECT_EQ(at(walls_of(20), 45, 8), Structure::none) << "8 m";
}

TEST(Structures, AShedIsNoHouseFromTheAir) {
  CellScene scene;
  scene.add({10, 10, 10, 10}, StandingForm::inclined, 3000);
  scene.add({40, 10, 25, 25}, StandingForm::inclined, 6000);
  const Image found = scene.structure(60, StreetView::air);
  EXPECT_EQ(at(found, 15, 15), Structure::none);
  EXPECT_EQ(at(found, 52, 22), Structure::roof);
}

// A roof with an edge of two cells of no plane all around, a crown that reaches to it, and a crown that stands alone.
CellScene roof_and_crowns() {
  CellScene scene;
  scene.add({12, 12, 26, 26}, StandingForm::inclined, 8000);
  scene.add({10, 10, 30, 2}, StandingForm::volume, 8000);
  scene.add({10, 38, 30, 2}, StandingForm::volume, 8000);
  scene.add({10, 12, 2, 26}, StandingForm::volume, 8000);
  scene.add({38, 12, 2, 26}, StandingForm::volume, 8000);
  scene.add({40, 18, 12, 12}, StandingForm::volume, 7000);
  scene.add({70, 20, 8, 8}, StandingForm::volume, 7000);
  return scene;
}

TEST(Structures, TheEdgeOfARoofFromTheAirIsNoCrown) {
  const Image found = roof_and_crowns().structure(60, StreetView::air);
  for (std::size_t along = 13; along < 37; ++along) {  // corners of an edge of two cells are as wide as a crown
    for (const std::size_t across : {10u, 11u, 38u, 39u}) EXPECT_EQ(at(found, along, across), Structure::roof) << along;
    for (const std::size_t across : {10u, 11u}) EXPECT_EQ(at(found, across, along), Structure::roof) << along;
  }
  EXPECT_EQ(at(found, 46, 24), Structure::crown);
  EXPECT_EQ(at(found, 73, 23), Structure::crown);
  EXPECT_EQ(at(found, 25, 25), Structure::roof);
}

TEST(Structures, TheTilesDoNotDecide) {
  const CellScene above = roof_and_crowns();
  const Image of_above = above.structure(100, StreetView::air);
  for (const std::uint32_t side : {16u, 37u})
    EXPECT_EQ(above.structure(side, StreetView::air).values, of_above.values) << side;
  const StreetScene scene = busy_scene();
  const Image want = scene.structure(100);
  for (const std::uint32_t side : {16u, 37u}) EXPECT_EQ(scene.structure(side).values, want.values) << side;
}

}  // namespace
}  // namespace ilot
