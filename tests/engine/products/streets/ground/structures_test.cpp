// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/structures.h"

#include <gtest/gtest.h>

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

CellScene busy_scene() {
  CellScene scene;
  scene.add({5, 10, 60, 1}, StandingForm::upright, 9000);    // a wall
  scene.add({20, 25, 12, 12}, StandingForm::volume, 7000);   // a crown
  scene.add({50, 30, 1, 1}, StandingForm::upright, 6000);    // a post
  scene.add({60, 40, 30, 1}, StandingForm::upright, 2100);   // a wall that is cut at 2.1 m
  scene.add({60, 48, 12, 1}, StandingForm::upright, 2300);   // the side of a van
  scene.add({75, 5, 20, 20}, StandingForm::inclined, 8000);  // a roof
  return scene;
}

Structure at(const Image& structure, std::size_t x, std::size_t y) {
  return static_cast<Structure>(structure.values[y * kCellsWide + x]);
}

TEST(Structures, WallsRoofsCrownsAndTheRest) {
  const Image found = busy_scene().structure(60, StreetView::street);
  EXPECT_EQ(at(found, 30, 10), Structure::wall);
  EXPECT_EQ(at(found, 26, 31), Structure::crown);
  EXPECT_EQ(at(found, 50, 30), Structure::none);
  EXPECT_EQ(at(found, 75, 40), Structure::wall);
  EXPECT_EQ(at(found, 66, 48), Structure::none);
  EXPECT_EQ(at(found, 85, 15), Structure::roof);
  EXPECT_EQ(at(found, 30, 20), Structure::none) << "nothing stands there";
}

TEST(Structures, BelowABalconyAndAroundAPostIsTheStreet) {
  CellScene scene;
  scene.add({5, 10, 60, 1}, StandingForm::upright, 9000);   // a wall
  scene.add({40, 11, 6, 2}, StandingForm::inclined, 4000);  // a balcony
  scene.add({30, 13, 1, 1}, StandingForm::upright, 6000);   // a post before the wall
  scene.add({15, 11, 1, 2}, StandingForm::upright, 9000);   // a party wall that leaves it
  const Image found = scene.structure(60, StreetView::street), from_above = scene.structure(60, StreetView::air);
  EXPECT_EQ(at(found, 42, 10), Structure::wall);
  EXPECT_EQ(at(found, 42, 11), Structure::overhang);
  EXPECT_EQ(at(found, 42, 12), Structure::overhang);
  EXPECT_EQ(at(found, 30, 13), Structure::none);
  EXPECT_EQ(at(found, 15, 11), Structure::wall);
  EXPECT_EQ(at(found, 42, 14), Structure::none);
  EXPECT_EQ(at(from_above, 42, 10), Structure::wall);
  EXPECT_EQ(at(from_above, 42, 11), Structure::roof) << "from above it is a roof of the building";
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
  const CellScene scene = busy_scene();
  const Image want = scene.structure(100, StreetView::street);
  for (const std::uint32_t side : {16u, 37u})
    EXPECT_EQ(scene.structure(side, StreetView::street).values, want.values) << side;
}

}  // namespace
}  // namespace ilot
