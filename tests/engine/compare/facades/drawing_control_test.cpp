// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/drawing_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/deliverables/drawings/cad/dxf_writer.h"
#include "engine/error.h"

namespace ilot {
namespace {

DxfDrawing drawing_with(const std::vector<DrawingLine>& lines) {
  Drawing drawing;
  drawing.lines = lines;
  return parse_dxf(drawing_dxf(drawing, preset_layers("ilot")), "a.dxf");
}

DrawingLine box(DrawingRole role, double x, double y, double dx = 0, double dy = 0) {
  return {
      role, {{x + dx, y + dy, 0}, {x + 1 + dx, y + dy, 0}, {x + 1 + dx, y + 2 + dy, 0}, {x + dx, y + 2 + dy, 0}}, true};
}

using R = DrawingRole;

TEST(DrawingControl, TheSameDrawingHasNothingToCorrect) {
  const DxfDrawing ours = drawing_with({box(R::opening, 0, 0), box(R::sill, 5, 5), box(R::dimension, 9, 9)});
  const auto layers = compare_drawings(ours, ours);
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[0].layer, "FAC-OPENING");
  EXPECT_EQ(layers[1].layer, "FAC-SILL");
  EXPECT_EQ(layers[2].layer, "");
  EXPECT_EQ(layers[2].corrected, 8u);  // no dimensions
  for (const LayerControl& c : layers) {
    EXPECT_EQ(c.paired, c.corrected);
    EXPECT_EQ(c.missed + c.removed + c.moved, 0u);
    EXPECT_EQ(c.dd_m.mean, 0);
  }
}

TEST(DrawingControl, MovedMissedAndRemoved) {
  const DxfDrawing ours = drawing_with({box(R::opening, 0, 0), box(R::opening, 4, 0), box(R::sill, 0, 8)});
  const DxfDrawing theirs =
      drawing_with({box(R::opening, 0, 0, -0.03, 0.04), box(R::opening, 8, 0), box(R::opening, 0, 8)});
  const auto layers = compare_drawings(ours, theirs);
  ASSERT_EQ(layers.size(), 3u);
  const LayerControl& opening = layers[0];
  EXPECT_EQ(opening.corrected, 12u);
  EXPECT_EQ(opening.paired, 4u);
  EXPECT_EQ(opening.missed, 8u);
  EXPECT_EQ(opening.removed, 4u);
  EXPECT_EQ(opening.moved, 4u);
  EXPECT_NEAR(opening.dx_m.mean, 0.03, 1e-9);
  EXPECT_NEAR(opening.dz_m.mean, 0.04, 1e-9);
  EXPECT_NEAR(opening.dd_m.mean, 0.05, 1e-9);
  EXPECT_NEAR(opening.dd_m.sd, 0, 1e-9);
  EXPECT_NEAR(opening.signed_dx_m.mean, 0.03, 1e-9);
  EXPECT_NEAR(opening.signed_dz_m.mean, -0.04, 1e-9);
  EXPECT_NEAR(opening.largest_m, 0.05, 1e-9);
  ASSERT_EQ(opening.vertices.size(), 4u);
  for (const VertexControl& v : opening.vertices) {
    EXPECT_NEAR(v.dx, 0.03, 1e-9);
    EXPECT_NEAR(v.dz, -0.04, 1e-9);
    EXPECT_NEAR(v.dd, 0.05, 1e-9);
    EXPECT_TRUE(std::abs(v.x + 0.03) < 1e-9 || std::abs(v.x - 0.97) < 1e-9) << v.x;
  }
  EXPECT_NE(drawing_control_text(layers).find("3.00     -4.00      5.00\n"), std::string::npos);
  EXPECT_EQ(layers[1].removed, 4u);  // the sill went to another layer
  EXPECT_EQ(layers[2].paired, 8u);   // and is the same vertex of all
  EXPECT_EQ(compare_drawings(ours, theirs, {0.04, preset_layers("ilot")})[0].paired, 0u);
}

TEST(DrawingControl, OneVertexServesOneOther) {
  const DxfDrawing ours = drawing_with({{R::opening, {{0, 0, 0}, {5, 0, 0}}, false}});
  const DxfDrawing theirs =
      drawing_with({{R::opening, {{0.1, 0, 0}, {5, 0, 0}}, false}, {R::opening, {{0.02, 0, 0}, {9, 0, 0}}, false}});
  const LayerControl all = compare_drawings(ours, theirs).back();
  EXPECT_EQ(all.paired, 2u);
  EXPECT_EQ(all.missed, 2u);
  EXPECT_NEAR(all.largest_m, 0.02, 1e-9);
}

TEST(DrawingControl, EndsOfArcsAndReports) {
  Drawing drawing;
  drawing.arcs.push_back({R::detail, 1, 1, 2, 0, 90});
  const DxfDrawing arc = parse_dxf(drawing_dxf(drawing, preset_layers("ilot")), "a.dxf");
  const auto layers = compare_drawings(arc, drawing_with({{R::detail, {{3, 1, 0}, {1, 3, 0}}, false}}));
  EXPECT_EQ(layers.back().paired, 2u);
  EXPECT_EQ(layers.back().moved, 0u);
  const auto json = nlohmann::json::parse(drawing_control_json(layers));
  EXPECT_EQ(json["drawing"].back()["layer"], "all");
  EXPECT_EQ(json["drawing"].back()["paired"], 2);
  EXPECT_NE(drawing_control_text(layers).find("FAC-DETAIL"), std::string::npos);
}

TEST(DrawingControl, OnlyMetresAreCompared) {
  const DxfDrawing ours = drawing_with({box(R::opening, 0, 0)});
  DxfDrawing theirs = ours;
  theirs.units = 4;
  EXPECT_THROW(compare_drawings(ours, theirs), Error);
  EXPECT_THROW(compare_drawings(theirs, ours), Error);
}

}  // namespace
}  // namespace ilot
