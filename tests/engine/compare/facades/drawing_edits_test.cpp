// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/drawing_edits.h"

#include <gtest/gtest.h>

#include "engine/deliverables/drawings/cad/dxf_writer.h"
#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/error.h"

namespace ilot {
namespace {

constexpr double kUnit = 0.3048;  // metres in a unit of the CRS

// A wall along y, with the windows at these places along it.
Facade wall_with(const std::vector<FlatBox>& windows, const std::string& kind = "window") {
  Facade f;
  f.id = 7;
  f.origin = {1000, 2000, 30};
  f.right = {0, 1, 0};
  f.up = {0, 0, 1};
  f.out = {1, 0, 0};
  f.width_m = 20, f.height_m = 9;
  const auto add = [&](const std::string& name, const FlatBox& b) {
    FacadeElement& e = f.elements.emplace_back();
    e.id = static_cast<std::uint32_t>(f.elements.size());
    e.kind = name;
    e.opening = name != "outline" && name != "sill";
    for (const FlatPoint p : {b.min, FlatPoint{b.max.x, b.min.y}, b.max, FlatPoint{b.min.x, b.max.y}})
      e.ring.push_back(f.origin + (p.x / kUnit) * f.right + (p.y / kUnit) * f.up);
    e.edges.resize(4);
    e.width_m = b.width(), e.height_m = b.height();
  };
  add("outline", {{0, 0}, {20, 9}});
  add("sill", {{1, 0.8}, {2, 0.9}});
  for (const FlatBox& window : windows) add(kind, window);
  return f;
}

DxfDrawing drawn(const Facade& f) {
  FacadeDrawingParams params;
  params.metres_per_unit = kUnit;
  return parse_dxf(drawing_dxf(facade_drawing(f, params), preset_layers("ilot")), "ours.dxf");
}

DrawingEdits edits(const Facade& ours, const DxfDrawing& theirs) {
  return drawing_edits(drawn(ours), theirs, ours, preset_layers("ilot"));
}

// The facade's own foot is at 30 units: 9.144 m in the drawing.
constexpr double kFoot = 30 * kUnit;

DxfEntity line(const std::string& layer, double x0, double y0, double x1, double y1) {
  DxfEntity e;
  e.type = "LINE";
  e.layer = layer;
  e.corners = {{x0, y0 + kFoot}, {x1, y1 + kFoot}};
  return e;
}

const std::vector<FlatBox> kThree{{{1, 1}, {2, 3}}, {{4, 1}, {5, 3}}, {{7, 1}, {8, 3}}};

TEST(DrawingEdits, TheSameDrawingHasNone) {
  const Facade f = wall_with(kThree);
  const DrawingEdits found = edits(f, drawn(f));
  EXPECT_TRUE(found.edits.empty());
  EXPECT_EQ(found.unchanged, 3u);
  EXPECT_EQ(found.loose, 0u);
}

TEST(DrawingEdits, MovedDeletedAddedInTheCoordinatesOfTheCloud) {
  const Facade f = wall_with(kThree);
  const Facade other = wall_with({{{1.25, 1}, {2.25, 3}}, {{4, 1}, {5, 3}}, {{12, 4}, {13, 6}}});
  DxfDrawing theirs = drawn(other);
  for (DxfEntity& e : theirs.entities)  // ids of another program
    if (e.type == "ATTRIB" && e.text.starts_with("ID=")) e.text = "ID=";
  const DrawingEdits found = edits(f, theirs);
  ASSERT_EQ(found.edits.size(), 3u);
  EXPECT_EQ(found.unchanged, 1u);
  const Edit &moved = found.edits[0], &deleted = found.edits[1], &added = found.edits[2];
  EXPECT_EQ(moved.action, EditAction::moved);
  ASSERT_EQ(moved.to.size(), 2u);
  EXPECT_NEAR(moved.at[0].y, 2000 + 1 / kUnit, 1e-6);
  EXPECT_NEAR(moved.to[0].y, 2000 + 1.25 / kUnit, 1e-6);
  EXPECT_NEAR(moved.to[1].z, 30 + 3 / kUnit, 1e-6);
  EXPECT_NEAR(moved.to[0].x, 1000, 1e-9);
  EXPECT_EQ(deleted.action, EditAction::deleted);
  EXPECT_NEAR(deleted.at[0].y, 2000 + 7 / kUnit, 1e-6);
  EXPECT_EQ(added.action, EditAction::added);
  EXPECT_EQ(added.kind, "window");
  EXPECT_NEAR(added.at[1].z, 30 + 6 / kUnit, 1e-6);
}

TEST(DrawingEdits, ABlockThatMovedFarIsStillTheSame) {
  const Facade f = wall_with(kThree);
  const DrawingEdits found = edits(f, drawn(wall_with({kThree[0], {{14, 1}, {15, 3}}, kThree[2]})));
  ASSERT_EQ(found.edits.size(), 1u);
  EXPECT_EQ(found.edits[0].action, EditAction::moved);
}

TEST(DrawingEdits, AnotherKindAndExplodedBlocksAndLines) {
  const Facade f = wall_with(kThree);
  DxfDrawing theirs = drawn(f);
  bool renamed = false;
  std::vector<DxfEntity> entities;
  for (DxfEntity e : theirs.entities) {
    if (e.type == "INSERT" || e.type == "ATTRIB") {
      if (e.type == "ATTRIB" && e.text == "KIND=window" && !renamed) renamed = true;
      continue;  // all blocks are exploded
    }
    e.in_block = false;
    entities.push_back(e);
  }
  EXPECT_TRUE(renamed);
  const std::string layer = preset_layers("ilot")[DrawingRole::opening].name;
  for (const DxfEntity& e : {line(layer, 10, 1, 11, 1), line(layer, 11, 3, 11, 1), line(layer, 11, 3, 10, 3),
                             line(layer, 10, 3, 10, 1), line(layer, 15, 1, 16, 1)})
    entities.push_back(e);
  theirs.entities = entities;
  const DrawingEdits found = edits(f, theirs);
  ASSERT_EQ(found.edits.size(), 1u);
  EXPECT_EQ(found.edits[0].action, EditAction::added);
  EXPECT_EQ(found.unchanged, 3u);
  EXPECT_EQ(found.loose, 1u);
  DxfDrawing doors = drawn(f);
  std::size_t at = 0;
  while (doors.entities[at].text != "KIND=window") ++at;
  doors.entities[at].text = "KIND=door";
  const DrawingEdits kinds = edits(f, doors);
  ASSERT_EQ(kinds.edits.size(), 1u);
  EXPECT_EQ(kinds.edits[0].action, EditAction::kind);
  EXPECT_EQ(kinds.edits[0].kind, "window");
  EXPECT_EQ(kinds.edits[0].to_kind, "door");
}

TEST(DrawingEdits, MillimetresAreRefused) {
  const Facade f = wall_with(kThree);
  DxfDrawing theirs = drawn(f);
  theirs.units = 4;
  EXPECT_THROW(edits(f, theirs), Error);
}

}  // namespace
}  // namespace ilot
