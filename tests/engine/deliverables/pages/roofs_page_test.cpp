// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/roofs_page.h"

#include <gtest/gtest.h>

#include <regex>

#include "engine/deliverables/drawings/building_drawing.h"
#include "tests/support/buildings.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

Building house(const std::string& id, const std::string& status, const std::string& reason) {
  Building b = gable_house(id, {85000, 444000, 3});
  b.attributes = {{"status", status}, {"reason", reason}, {"roof_faces", std::int64_t{2}}};
  return b;
}

TEST(RoofsPage, CountsDrawsAndSaysWhy) {
  const TemporaryFolder folder;
  RoofsPage page(folder.path() / "roofs.html", 1);
  const std::vector<Vec3> points{{85001, 444001, 9}, {85002, 444002, 9}};
  for (int i = 0; i < 30; ++i)
    page.add(std::vector<Building>{house("h" + std::to_string(i), "lod22", "")}, points, i / 100.0);
  Building block = house("<b & c>", "lod12", "the solid is not valid: \"203\"");
  block.lod = "1.2";
  page.add(std::vector<Building>{block}, points, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "roofs.html"));
  page.finish();
  const std::string html = test::file_bytes(folder.path() / "roofs.html");
  EXPECT_NE(html.find("31 buildings"), std::string::npos);
  EXPECT_EQ(count_of(html, "<g class=\"lod22\">"), 30u);
  EXPECT_EQ(count_of(html, "<g class=\"lod12\">"), 1u);
  EXPECT_EQ(count_of(html, "<figure>"), 36u) << "twelve of each choice";
  EXPECT_EQ(count_of(html, "<b & c>"), 0u);
  EXPECT_NE(html.find("<td>&lt;b &amp; c&gt;</td><td>lod12</td><td>the solid is not valid: &quot;203&quot;</td>"),
            std::string::npos);
  const std::size_t worst = html.find("Most points off");
  EXPECT_LT(html.find("h29: ", worst), html.find("h28: ", worst)) << "the worst first";
  EXPECT_GT(html.find("h17: ", worst), html.find("Most faces")) << "only twelve";
}

TEST(RoofsPage, WithoutABuildingSaysSo) {
  const TemporaryFolder folder;
  RoofsPage page(folder.path() / "roofs.html", 1);
  page.finish();
  EXPECT_NE(test::file_bytes(folder.path() / "roofs.html").find("0 buildings"), std::string::npos);
}

TEST(BuildingDrawing, PlanHasTheRoofAloneAndNorthUp) {
  const std::string paths = plan_paths(gable_house("a", {10, 20, 0}), {10, 20, 0});
  EXPECT_EQ(count_of(paths, "<path"), 2u);
  const std::regex corner("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator at(paths.begin(), paths.end(), corner), end; at != end; ++at) {
    EXPECT_GE(std::stod((*at)[1]), 0) << "east of its corner";
    EXPECT_LE(std::stod((*at)[2]), 0) << "north of its corner";
  }
}

TEST(BuildingDrawing, ShowsWhatLooksAtUsWithinThePicture) {
  const std::vector<Vec3> points{{2, 2, 5}};
  const std::string svg = oblique_drawing(gable_house("a", {}), points, 300, 200);
  EXPECT_EQ(count_of(svg, "<circle"), 1u);
  EXPECT_GE(count_of(svg, "<path"), 3u);
  EXPECT_LT(count_of(svg, "<path"), 7u) << "walls at the back and the floor are hidden";
  const std::regex corner("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator at(svg.begin(), svg.end(), corner), end; at != end; ++at) {
    EXPECT_GE(std::stod((*at)[1]), 0);
    EXPECT_LE(std::stod((*at)[1]), 300);
    EXPECT_GE(std::stod((*at)[2]), 0);
    EXPECT_LE(std::stod((*at)[2]), 200);
  }
}

}  // namespace
}  // namespace ilot
