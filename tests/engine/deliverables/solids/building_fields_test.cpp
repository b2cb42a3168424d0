// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/building_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "engine/products/roofs/solids/building_attributes.h"
#include "tests/support/buildings.h"

namespace ilot {
namespace {

const AttributeValue& at(const Attributes& attributes, const std::string& name) {
  for (const auto& [key, value] : attributes)
    if (key == name) return value;
  throw std::out_of_range(name);
}

Attributes attributes() {
  return {{"status", std::string("lod22")},
          {"points", std::int64_t{800}},
          {"area_m2", 80.0},
          {"volume_lod13_m3", 360.0},
          {"coverage", 0.9},
          {"h_roof_50", 4.5},
          {"mine", 1.0}};
}

TEST(BuildingFields, PlainNamesStay) {
  EXPECT_EQ(styled_attributes(attributes(), AttributeStyle::plain), attributes());
  EXPECT_TRUE(styled_attributes({}, AttributeStyle::roofer).empty());
}

TEST(BuildingFields, RoofersStyleRenamesAndAdds) {
  const Attributes out = styled_attributes(attributes(), AttributeStyle::roofer);
  EXPECT_EQ(std::get<double>(at(out, "rf_h_roof_50p")), 4.5);
  EXPECT_EQ(std::get<double>(at(out, "mine")), 1);
  EXPECT_TRUE(std::get<bool>(at(out, "rf_success")));
  EXPECT_EQ(std::get<std::string>(at(out, "rf_extrusion_mode")), "standard");
  EXPECT_DOUBLE_EQ(std::get<double>(at(out, "rf_nodata_frac")), 0.1);
  EXPECT_EQ(std::get<double>(at(out, "rf_pt_density")), 10);
  EXPECT_EQ(std::get<double>(at(out, "rf_volume_lod13")), 360);
  EXPECT_THROW(at(out, "h_roof_50"), std::out_of_range);
}

TEST(BuildingFields, TheNamesOfAFieldFindItInEveryStyle) {
  for (const char* status : {"lod22", "lod12", "footprint_only"}) {
    Attributes plain = attributes();
    plain[0].second = std::string(status);
    plain.emplace_back("rmse_m", 0.25);
    const Attributes out = styled_attributes(plain, AttributeStyle::roofer);
    for (const BuildingField& field : building_fields()) {
      const bool had = std::any_of(plain.begin(), plain.end(), [&](const auto& a) { return a.first == field.name; });
      const std::vector<std::string> names = names_of(field);
      const auto found = std::count_if(out.begin(), out.end(), [&](const auto& a) {
        return std::find(names.begin(), names.end(), a.first) != names.end();
      });
      EXPECT_EQ(found, had ? 1 : 0) << field.name << " " << status;
    }
  }
}

TEST(BuildingFields, EveryAttributeOfAModelIsInTheTable) {
  std::set<std::string> known;
  for (const BuildingField& field : building_fields()) EXPECT_TRUE(known.insert(field.name).second) << field.name;
  RoofSite site;
  site.outline = {{{0, 0}, {10000, 0}, {10000, 8000}, {0, 8000}}};
  for (int i = 0; i < 100; ++i) site.points.push_back({i % 10 + 0.5, i / 10 * 0.8, 4});
  RoofModel model;
  model.status = RoofStatus::lod22;
  model.lod22 = gable_house("a", {});
  model.face_of_point.assign(100, 1);
  PointMeasures measures(site, model, 1);
  for (const Vec3& p : site.points) measures.add(p, 1);
  for (const auto& [name, value] : building_attributes(site, model, 1, measures))
    EXPECT_TRUE(known.count(name)) << name;
}

TEST(BuildingFields, NoPointGivesNoGround) {
  RoofSite site;
  site.outline = {{{0, 0}, {10000, 0}, {10000, 8000}, {0, 8000}}};
  site.ground_source = GroundSource::none;
  const RoofModel model;
  PointMeasures measures(site, model, 1);
  for (const auto& [name, value] : building_attributes(site, model, 1, measures)) {
    EXPECT_NE(name, "h_ground");
    EXPECT_NE(name, "ground_source");
  }
}

TEST(BuildingFields, ColumnsHaveTheNamesOfTheAttributes) {
  for (const AttributeStyle style : {AttributeStyle::plain, AttributeStyle::roofer}) {
    std::set<std::string> columns{"mine"};
    for (const auto& [name, kind] : attribute_columns(style)) EXPECT_TRUE(columns.insert(name).second) << name;
    for (const auto& [name, value] : styled_attributes(attributes(), style)) EXPECT_TRUE(columns.count(name)) << name;
    std::set<std::string> faces;
    for (const auto& [name, kind] : face_columns(style)) faces.insert(name);
    for (const auto& [name, value] : face_attributes({1, 30, 90}, {1, 2, 3, 4}, style))
      EXPECT_TRUE(faces.count(name)) << name;
  }
  EXPECT_EQ(face_attributes({1, 0, -1}, {}, AttributeStyle::plain).size(), 6u);
}

TEST(BuildingFields, TheDocumentShowsTheTables) {
  const std::string path = std::string(ILOT_SOURCE_DIR) + "/docs/outputs.md";
  std::string text;
  {
    std::ifstream file(path);
    text.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::string start = "<!-- attributes: made from the code, ILOT_UPDATE_GOLDEN=1 -->\n",
                    end = "<!-- end of attributes -->";
  const std::size_t from = text.find(start), to = text.find(end);
  ASSERT_NE(from, text.npos);
  ASSERT_NE(to, text.npos);
  const std::string wanted = "\n" + building_fields_markdown() + "\n";
  if (std::getenv("ILOT_UPDATE_GOLDEN") != nullptr) {
    text.replace(from + start.size(), to - from - start.size(), wanted);
    std::ofstream(path) << text;
    return;
  }
  EXPECT_EQ(text.substr(from + start.size(), to - from - start.size()), wanted)
      << "run this test with ILOT_UPDATE_GOLDEN=1 and review docs/outputs.md";
}

}  // namespace
}  // namespace ilot
