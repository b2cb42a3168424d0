// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/deliverables/drawings/cad/dxf_writer.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

DxfDrawing a_drawing() {
  Drawing drawing;
  drawing.lines.push_back({DrawingRole::opening, {{0, 0, 0}, {2, 0, 0}, {2, 3, 1}, {0, 3, 0}}, true});
  drawing.lines.push_back({DrawingRole::sill, {{0, 0, 0}, {2, 0, 0}}, false});
  drawing.arcs.push_back({DrawingRole::detail, 4, 4, 0.5, 350, 10});
  return parse_dxf(drawing_dxf(drawing, preset_layers("ilot")), "a.dxf");
}

std::vector<std::string> rules_of(const DxfDrawing& drawing) {
  std::vector<std::string> rules;
  for (const Finding& f : validate_drawing(drawing)) rules.push_back(f.rule + (f.severe ? "" : "?"));
  return rules;
}

using Rules = std::vector<std::string>;

TEST(ValidateDrawing, OursHasNoFinding) {
  EXPECT_EQ(rules_of(a_drawing()), Rules{});
}

TEST(ValidateDrawing, EachFaultIsFound) {
  DxfDrawing d = a_drawing();
  d.has_end = false;
  d.sections.erase("TABLES");
  EXPECT_EQ(rules_of(d), (Rules{"structure", "structure"}));
  d = a_drawing();
  d.units.reset();
  EXPECT_EQ(rules_of(d), Rules{"units"});
  d.units = 0;
  EXPECT_EQ(rules_of(d), Rules{"units"});
  d.units = 4;
  EXPECT_EQ(rules_of(d), Rules{"units?"});
  EXPECT_NE(validate_drawing(d)[0].text.find("millimetres"), std::string::npos);
  d.units = 99;
  EXPECT_EQ(rules_of(d), Rules{"units?"});
  d = a_drawing();
  d.entities[0].layer = "nowhere";
  EXPECT_EQ(rules_of(d), Rules{"layer"});
  d.entities[0].layer = "fac-opening";  // names do not tell capitals apart
  EXPECT_EQ(rules_of(d), Rules{});
  d.entities[1].handle = d.entities[0].handle;
  EXPECT_EQ(rules_of(d), Rules{"handle"});
  d = a_drawing();
  d.entities[1].finite = false;
  EXPECT_EQ(rules_of(d), Rules{"number"});
  d = a_drawing();
  d.entities[1].corners.resize(1);
  EXPECT_EQ(rules_of(d), Rules{"empty"});
  d = a_drawing();
  d.entities[0].corners.insert(d.entities[0].corners.begin(), {1e-6, 0, 0});
  EXPECT_EQ(rules_of(d), Rules{"zero-length"});
  d = a_drawing();
  d.entities[2].radius = 0;
  EXPECT_EQ(rules_of(d), Rules{"zero-length"});
  d = a_drawing();
  d.entities[0].closed = false;
  d.entities[0].corners.push_back(d.entities[0].corners[0]);
  EXPECT_EQ(rules_of(d), Rules{"open-ring"});
}

TEST(ValidateDrawing, DuplicatesWhereverTheyBegin) {
  DxfDrawing d = a_drawing();
  DxfEntity turned = d.entities[0];
  turned.handle.clear();
  std::rotate(turned.corners.begin(), turned.corners.begin() + 2, turned.corners.end());
  d.entities.push_back(turned);
  EXPECT_EQ(rules_of(d), Rules{"duplicate"});
  d.entities.back().corners[1].x += 0.001;
  EXPECT_EQ(rules_of(d), Rules{});
  d.entities.back() = d.entities[1];
  d.entities.back().handle.clear();
  std::reverse(d.entities.back().corners.begin(), d.entities.back().corners.end());
  EXPECT_EQ(rules_of(d), Rules{"duplicate"});
  d.entities.back().layer = "FAC-OPENING";
  EXPECT_EQ(rules_of(d), Rules{});
}

TEST(ValidateDrawing, FilesThatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(validate_drawing_file(folder.put("a.dxf", "hello\n")).at(0).rule, "unreadable");
  EXPECT_EQ(validate_drawing_file(folder.path() / "none.dxf").at(0).rule, "unreadable");
  EXPECT_EQ(validate_drawing_file(folder.put("b.dxf", "")).size(), 5u);  // three sections, the end, the unit
  EXPECT_TRUE(is_dxf_file("a/b.DXF"));
  EXPECT_FALSE(is_dxf_file("a/dxf"));
}

}  // namespace
}  // namespace ilot
