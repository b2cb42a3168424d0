// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_svg.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "engine/deliverables/drawings/facade_drawing.h"
#include "tests/support/facades.h"

namespace ilot {
namespace {

Drawing screen_drawing() {
  Drawing drawing;
  drawing.title =
      "<Fa\xC3\xA7"
      "ade> & \"co\"";
  drawing.sheet = {0, 0, 10.5, 14.85};  // A4 at 1:50
  drawing.lines.push_back({DrawingRole::opening, {{0, 0, 0}, {2, 0, 0}, {2, 3, 1}, {0, 3, 0}}, true});
  drawing.lines.push_back({DrawingRole::error, {{0, 0, 0}, {1, 1, 0}}, false});
  drawing.texts.push_back({DrawingRole::number, 1, 1, 0.125, 90, TextAnchor::right, "a<b\x01"});
  return drawing;
}

TEST(DrawingSvg, IsToScaleInMillimetres) {
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(drawing_svg(screen_drawing(), preset_layers("ilot")).c_str()));
  const pugi::xml_node root = svg.child("svg");
  EXPECT_STREQ(root.attribute("width").value(), "210.000mm");
  EXPECT_STREQ(root.attribute("viewBox").value(), "0 0 210.000 297.000");
  const pugi::xml_node opening = root.find_child_by_attribute("g", "class", "role-opening");
  EXPECT_STREQ(opening.attribute("data-layer").value(), "FAC-OPENING");
  EXPECT_STREQ(opening.child("g").attribute("stroke-width").value(), "0.35");
  // 2 m are 40 mm; the half circle turns left, which is counter-clockwise on paper too.
  EXPECT_STREQ(opening.child("g").child("path").attribute("d").value(),
               "M0.000 297.000L40.000 297.000L40.000 237.000A20.000 20.000 0 0 0 0.000 237.000Z");
  EXPECT_STREQ(root.find_child_by_attribute("g", "class", "role-error").attribute("style").value(), "display:none");
  const pugi::xml_node text = root.find_child_by_attribute("g", "class", "role-number").child("g").child("text");
  EXPECT_STREQ(text.text().get(), "a<b ");
  EXPECT_STREQ(text.attribute("text-anchor").value(), "end");
  EXPECT_STREQ(text.attribute("transform").value(), "rotate(-90.000 20.000 277.000)");
  EXPECT_NEAR(text.attribute("font-size").as_double(), 2.5 / 0.716, 1e-3);
  EXPECT_STREQ(root.child("title").text().get(),
               "<Fa\xC3\xA7"
               "ade> & \"co\"");
}

TEST(DrawingSvg, ThePlanAloneOverAnImage) {
  const Drawing drawing = facade_drawing(facade_of({drawn("window", wall_rectangle(1, 1, 2, 3))}));
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(
      drawing_svg(drawing, preset_layers("ilot"), SvgPart::plan, SvgUnderlay{"a b.png?<", {0, 0, 4, 4}}).c_str()));
  const pugi::xml_node root = svg.child("svg");
  EXPECT_FALSE(root.find_child_by_attribute("g", "class", "role-frame"));
  EXPECT_FALSE(root.find_child_by_attribute("g", "class", "role-title"));
  EXPECT_STREQ(root.child("image").attribute("href").value(), "a b.png?<");
  EXPECT_NEAR(root.child("image").attribute("width").as_double(), 80, 1e-9);
  EXPECT_LT(root.attribute("width").as_double(), 100);
}

}  // namespace
}  // namespace ilot
