// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_layers.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::string layers_fault(const std::string& text) {
  try {
    parse_layers(text, "l.toml");
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
    return fault.what();
  }
  return "none";
}

TEST(DrawingLayers, PresetsHaveALayerForEachMeaning) {
  for (const char* preset : {"ilot", "aia", "iso13567"}) {
    std::set<std::string> names;
    for (const DrawingLayer& layer : preset_layers(preset).of_role) {
      names.insert(layer.name);
      if (std::string(preset) == "iso13567") {
        EXPECT_EQ(layer.name.size(), 10u) << layer.name;
      }
    }
    EXPECT_EQ(names.size(), kDrawingRoles) << preset;
  }
  EXPECT_THROW(preset_layers("office"), Error);
  EXPECT_FALSE(preset_layers("aia")[DrawingRole::error].shown);
}

TEST(DrawingLayers, AMappingChangesWhatItNames) {
  const TemporaryFolder folder;
  const auto file = folder.put("l.toml",
                               "preset = \"aia\"\n[layers.opening]\nname = \"BAIES\"\ncolour = 3\nlineweight_mm = 0.5\n"
                               "pattern = \"dashed\"\nshown = false\n[layers.sill]\nname = \"A-ELEV-HEAD\"\n");
  const DrawingLayers layers = read_layers(file.string());
  EXPECT_EQ(layers[DrawingRole::opening].name, "BAIES");
  EXPECT_EQ(layers[DrawingRole::opening].colour, 3);
  EXPECT_EQ(layers[DrawingRole::opening].lineweight_mm, 0.5);
  EXPECT_EQ(layers[DrawingRole::opening].pattern, LinePattern::dashed);
  EXPECT_FALSE(layers[DrawingRole::opening].shown);
  EXPECT_EQ(layers[DrawingRole::sill].name, "A-ELEV-HEAD");  // agrees with the lintel's
  EXPECT_EQ(layers[DrawingRole::band].name, "A-ELEV-MLDG");
  EXPECT_EQ(read_layers("iso13567")[DrawingRole::opening].name, "B-31----E-");
}

TEST(DrawingLayers, FaultsAreNamed) {
  EXPECT_NE(layers_fault("[layers.windows]\n").find("layers.windows: nothing of this name is drawn; there are outline"),
            std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\nname = \"a/b\"\n").find("name needs"), std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\nname = \"\"\n").find("name needs"), std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\ncolour = 256\n").find("colour needs"), std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\nlineweight_mm = 0.22\n").find("needs a pen"), std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\npattern = \"wavy\"\n").find("continuous, dashed, dotted"),
            std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\nshown = 1\n").find("true or false"), std::string::npos);
  EXPECT_NE(layers_fault("[layers.opening]\nweight = 1\n").find("unknown key 'weight'"), std::string::npos);
  EXPECT_NE(layers_fault("layers = 1\n").find("'layers'"), std::string::npos);
  EXPECT_NE(layers_fault("layers.opening = 1\n").find("needs a table"), std::string::npos);
  EXPECT_NE(layers_fault("preset = \"b\"\n").find("'b' is no set of layers"), std::string::npos);
  EXPECT_NE(layers_fault("[layers\n").find("l.toml:"), std::string::npos);
  EXPECT_NE(layers_fault("# \xC3\xA9\n").find("ASCII"), std::string::npos);
  // One layer, two colours; names that differ in case alone are one for CAD programs.
  EXPECT_NE(layers_fault("[layers.band]\nname = \"FAC-OPENING\"\n").find("opening and band share"), std::string::npos);
  EXPECT_NE(layers_fault("[layers.lintel]\nname = \"fac-sill\"\n").find("sill and lintel share"), std::string::npos);
  EXPECT_EQ(layers_fault("[layers.lintel]\nname = \"FAC-SILL\"\n"), "none");
  EXPECT_THROW(read_layers("/nowhere/layers.toml"), Error);
}

TEST(DrawingLayers, ColoursOnPaper) {
  EXPECT_EQ(colour_on_paper(1), (std::array<std::uint8_t, 3>{255, 0, 0}));
  EXPECT_EQ(colour_on_paper(7), (std::array<std::uint8_t, 3>{0, 0, 0}));
  EXPECT_EQ(colour_on_paper(10), (std::array<std::uint8_t, 3>{255, 0, 0}));
  EXPECT_EQ(colour_on_paper(90), (std::array<std::uint8_t, 3>{0, 255, 0}));
  EXPECT_EQ(colour_on_paper(170), (std::array<std::uint8_t, 3>{0, 0, 255}));
}

}  // namespace
}  // namespace ilot
