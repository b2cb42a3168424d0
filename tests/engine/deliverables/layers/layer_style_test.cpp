// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/layer_style.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <pugixml.hpp>

#include "engine/deliverables/layers/streets_gpkg.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(LayerStyle, HasASymbolForEachClass) {
  for (const LayerStyle& style : {style_of_buildings(), style_of_roof_faces(), style_of_planes(), style_of_blocks(),
                                  style_of_gaps(), style_of_objects(StyleSymbol::marker, {{PointLabel::car, "car"}})}) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(layer_style_qml(style).c_str())) << style.name;
    const pugi::xml_node renderer = document.child("qgis").child("renderer-v2");
    EXPECT_EQ(renderer.attribute("attr").as_string(), style.attribute);
    const auto symbols = renderer.child("symbols").children("symbol");
    EXPECT_EQ(static_cast<std::size_t>(std::distance(symbols.begin(), symbols.end())), style.classes.size());
    const auto listed = renderer.child(style.ranges ? "ranges" : "categories").children();
    const auto count = static_cast<std::size_t>(std::distance(listed.begin(), listed.end()));
    EXPECT_EQ(count, style.attribute.empty() ? 0 : style.classes.size());
    for (const pugi::xml_node& one : listed)
      EXPECT_TRUE(renderer.child("symbols").find_child_by_attribute("name", one.attribute("symbol").as_string()));
  }
}

TEST(LayerStyle, RangesFollowEachOther) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(layer_style_qml(style_of_planes()).c_str()));
  double last = 0;
  for (const pugi::xml_node& range : document.select_node("//ranges").node().children()) {
    EXPECT_EQ(range.attribute("lower").as_double(), last);
    last = range.attribute("upper").as_double();
  }
}

TEST(LayerStyle, IsTheDefaultOfItsLayerInTheFile) {
  const TemporaryFolder folder;
  StreetPlan plan;
  plan.objects.emplace_back().label = PointLabel::car;
  plan.objects.back().class_name = "car";
  write_objects_gpkg(folder.path() / "objects.gpkg", plan, {});
  const GDALDatasetUniquePtr file(GDALDataset::Open((folder.path() / "objects.gpkg").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(file);
  EXPECT_STREQ(file->GetLayer(0)->GetName(), "objects");
  OGRLayer* styles = file->GetLayerByName("layer_styles");
  ASSERT_NE(styles, nullptr);
  std::vector<std::string> layers;
  for (const OGRFeatureUniquePtr& feature : *styles) {
    layers.emplace_back(feature->GetFieldAsString("f_table_name"));
    EXPECT_EQ(feature->GetFieldAsInteger("useAsDefault"), 1);
    EXPECT_STREQ(file->GetLayerByName(layers.back().c_str())->GetGeometryColumn(),
                 feature->GetFieldAsString("f_geometry_column"));
  }
  EXPECT_EQ(layers, (std::vector<std::string>{"objects", "extents"}));
}

}  // namespace
}  // namespace ilot
