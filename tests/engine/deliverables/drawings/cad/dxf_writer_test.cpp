// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_writer.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <limits>
#include <set>

#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/error.h"
#include "engine/validity/validate_drawing.h"
#include "tests/support/facades.h"
#include "tests/support/temporary_folder.h"

extern "C" void RegisterOGRDXF();

namespace ilot {
namespace {

Drawing layered_drawing() {
  Drawing drawing;
  drawing.sheet = {-1, -1, 10, 10};
  drawing.lines.push_back({DrawingRole::opening, {{0, 0, 0}, {2, 0, 0}, {2, 3, 1}, {0, 3, 0}}, true});
  drawing.lines.push_back({DrawingRole::occluded, {{5, 5, 0}, {6, 6.123456, 0}}, false});
  drawing.arcs.push_back({DrawingRole::detail, 4, 4, 0.5, 350, 10});
  drawing.points.push_back({DrawingRole::section_points, 7, 7});
  drawing.texts.push_back({DrawingRole::number, 1, 1, 0.125, 0, TextAnchor::middle, "F\xC3\xA9n\xC3\xAAtre 12"});
  return drawing;
}

const DxfEntity& entity(const DxfDrawing& drawing, const std::string& type) {
  const auto found = std::find_if(drawing.entities.begin(), drawing.entities.end(),
                                  [&](const DxfEntity& e) { return e.type == type; });
  if (found == drawing.entities.end()) throw Error("no " + type);
  return *found;
}

TEST(DxfWriter, ReadsBack) {
  const DxfDrawing read = parse_dxf(drawing_dxf(layered_drawing(), preset_layers("aia")), "a.dxf");
  EXPECT_EQ(read.version, "AC1015");
  EXPECT_EQ(read.units, 6);
  EXPECT_TRUE(read.has_end);
  EXPECT_EQ(read.layers.size(), kDrawingRoles + 2);  // and 0 and that of viewports
  ASSERT_EQ(read.entities.size(), 6u);
  EXPECT_EQ(read.entities[5].layer, "Defpoints");  // the edge of the paper
  EXPECT_EQ(read.entities[5].corners.at(2).x, 10);
  const DxfEntity& door = read.entities[0];
  EXPECT_EQ(door.layer, "A-ELEV-OPNG");
  EXPECT_TRUE(door.closed);
  ASSERT_EQ(door.corners.size(), 4u);
  EXPECT_EQ(door.corners[2].bulge, 1);
  EXPECT_EQ(read.entities[1].corners[1].y, 6.12346);
  EXPECT_EQ(entity(read, "ARC").radius, 0.5);
  EXPECT_EQ(entity(read, "ARC").from_deg, 350);
  EXPECT_EQ(entity(read, "POINT").corners.at(0).x, 7);
  EXPECT_EQ(entity(read, "TEXT").text, "F\\U+00E9n\\U+00EAtre 12");
  std::set<std::string> handles;
  for (const DxfEntity& e : read.entities) EXPECT_TRUE(handles.insert(e.handle).second);
}

TEST(DxfWriter, SequencesOfTheFormatAreTakenApart) {
  Drawing drawing;
  for (const char* words : {"100%%d", "a^Ib", "\\U+0041", "x\n  0\nEOF", "\xF0\x9F\x8F\xA0", "\xFF", " ", ""})
    drawing.texts.push_back(
        {DrawingRole::title, 0, static_cast<double>(drawing.texts.size()), 1, 0, TextAnchor::left, words});
  const std::string dxf = drawing_dxf(drawing, preset_layers("ilot"));
  EXPECT_TRUE(std::all_of(dxf.begin(), dxf.end(), [](char c) { return c == '\n' || (c >= 32 && c < 127); }));
  const DxfDrawing read = parse_dxf(dxf, "a.dxf");
  std::vector<std::string> texts;
  for (const DxfEntity& e : read.entities) texts.push_back(e.text);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"100% %d", "a^ Ib", "\\U+005CU+0041", "x   0 EOF", "\\U+FFFD", "\\U+FFFD"}));
}

TEST(DxfWriter, LinesWithoutLengthAreLeftOut) {
  Drawing drawing;
  drawing.lines.push_back({DrawingRole::opening, {{1, 1, 0}, {1, 1.000001, 0}}, true});
  drawing.lines.push_back({DrawingRole::opening, {{1, 1, 0}, {2, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 1, 0}}, true});
  drawing.arcs.push_back({DrawingRole::detail, 0, 0, 0, 0, 90});
  const DxfDrawing read = parse_dxf(drawing_dxf(drawing, preset_layers("ilot")), "a.dxf");
  ASSERT_EQ(read.entities.size(), 1u);
  EXPECT_EQ(read.entities[0].corners.size(), 3u);
  drawing.lines.push_back({DrawingRole::opening, {{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}}, false});
  EXPECT_THROW(drawing_dxf(drawing, preset_layers("ilot")), Error);
}

TEST(DxfWriter, OursAreValidByOurOwnRules) {
  for (const char* preset : {"ilot", "aia", "iso13567"})
    EXPECT_TRUE(validate_drawing(
                    parse_dxf(drawing_dxf(facade_drawing(facade_of({drawn("window", wall_rectangle(1, 1, 2, 3)),
                                                                    drawn("sill", wall_rectangle(0.9, 0.9, 2.1, 1))})),
                                          preset_layers(preset)),
                              "a.dxf"))
                    .empty())
        << preset;
}

// Openings of one shape share a block; the reader puts them where they are.
TEST(DxfWriter, BlocksComeBackAtTheirPlaces) {
  Drawing drawing;
  for (const double x : {5.0, 9.0, 13.0})
    drawing.blocks.push_back({"window",
                              {x, 2},
                              {{DrawingRole::opening, {{x, 2}, {x + 1, 2}, {x + 1, 4, 1}, {x, 4}}, true}},
                              {},
                              {{"ID", decimal(x, 0)}, {"WIDTH", "1.000"}}});
  drawing.blocks[2].lines[0].corners[1].x += 0.5;
  const std::string dxf = drawing_dxf(drawing, preset_layers("ilot"));
  EXPECT_NE(dxf.find("WINDOW-2"), std::string::npos);
  EXPECT_EQ(dxf.find("WINDOW-3"), std::string::npos);
  const DxfDrawing read = parse_dxf(dxf, "a.dxf");
  std::vector<double> left;
  std::size_t attributes = 0;
  for (const DxfEntity& e : read.entities) {
    attributes += e.type == "ATTRIB";
    if (e.type != "LWPOLYLINE") continue;
    EXPECT_EQ(e.layer, "FAC-OPENING");
    EXPECT_EQ(e.corners.at(2).bulge, 1);
    left.push_back(e.corners.at(0).x);
  }
  EXPECT_EQ(left, (std::vector<double>{5, 9, 13}));
  EXPECT_EQ(attributes, 6u);
  EXPECT_TRUE(validate_drawing(read).empty());
}

TEST(DxfWriter, GdalReadsItAndItsArcs) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.dxf";
  write_drawing_dxf(path, layered_drawing(), preset_layers("ilot"));
  RegisterOGRDXF();
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(file);
  OGRLayer* layer = file->GetLayer(0);
  std::map<std::string, int> layers;
  double highest = 0;
  for (const auto& feature : *layer) {
    ++layers[feature->GetFieldAsString("Layer")];
    OGREnvelope box;
    feature->GetGeometryRef()->getEnvelope(&box);
    if (feature->GetFieldAsString("Layer") == std::string("FAC-OPENING")) highest = box.MaxY;
  }
  EXPECT_EQ(layers.size(), 6u);
  EXPECT_EQ(layers["FAC-TEXT"], 1);
  EXPECT_NEAR(highest, 4, 1e-3);
}

}  // namespace
}  // namespace ilot
