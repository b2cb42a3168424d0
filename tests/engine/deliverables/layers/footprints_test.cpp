// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/footprints.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "engine/formats/crs.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::string feature(const std::string& properties, const std::string& geometry) {
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":)" + geometry + "}";
}

std::string collection(const std::vector<std::string>& features, const std::string& crs = "EPSG::28992") {
  std::string text = R"({"type":"FeatureCollection",)";
  if (!crs.empty()) text += R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:)" + crs + R"("}},)";
  text += R"("features":[)";
  for (std::size_t i = 0; i < features.size(); ++i) text += (i ? "," : "") + features[i];
  return text + "]}";
}

const std::string kSquare =
    R"({"type":"Polygon","coordinates":[[[85000,447000],[85010,447000],[85010,447010],[85000,447000]]]})";

TEST(Footprints, EveryFeatureComesBackWithAnId) {
  const TemporaryFolder folder;
  const auto path =
      folder.put("f.geojson",
                 collection({feature(R"("name":"x","ID":7)", kSquare), feature(R"("ID":7)", kSquare),
                             feature(R"("ID":null)", kSquare), feature(R"("ID":9)", "null"),
                             feature(R"("ID":10)", R"({"type":"Point","coordinates":[85000,447000]})"),
                             feature(R"("ID":11)", R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1],[0,0]]],
                    [[[5,0],[9,0],[9,4],[5,0]],[[7,1],[8,1],[8,2],[7,1]]]]})")}));
  const FootprintFile file = read_footprints(path, crs_from_epsg(28992));
  ASSERT_EQ(file.footprints.size(), 6u);
  EXPECT_EQ(file.id_attribute, "ID");
  EXPECT_FALSE(file.transformed);
  const char* ids[]{"7", "7-2", "3", "9", "10", "11"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(file.footprints[i].id, ids[i]);
  EXPECT_EQ(file.footprints[0].parts,
            (std::vector<FootprintPolygon>{{{{85000, 447000}, {85010, 447000}, {85010, 447010}}}}));
  EXPECT_EQ(file.footprints[3].fault, "it has no geometry");
  EXPECT_EQ(file.footprints[4].fault, "it is a Point, not a polygon");
  ASSERT_EQ(file.footprints[5].parts.size(), 2u);
  EXPECT_EQ(file.footprints[5].parts[1].size(), 2u);
  EXPECT_EQ(file.warnings.size(), 1u) << "ids given twice";
}

TEST(Footprints, AnotherCrsIsTransformed) {
  const TemporaryFolder folder;
  // Degrees, as GeoJSON without a CRS has them: the Nieuwe Kerk of Delft.
  const auto path = folder.put(
      "wgs.geojson",
      collection(
          {feature(
              "",
              R"({"type":"Polygon","coordinates":[[[4.3600,52.0120],[4.3610,52.0120],[4.3610,52.0125],[4.3600,52.0120]]]})")},
          ""));
  const FootprintFile file = read_footprints(path, crs_from_epsg(28992));
  EXPECT_TRUE(file.transformed);
  EXPECT_EQ(file.id_attribute, "");
  EXPECT_EQ(file.footprints[0].id, "1");
  const auto& ring = file.footprints[0].parts.at(0).at(0);
  EXPECT_NEAR(ring[0][0], 84530, 300);
  EXPECT_NEAR(ring[0][1], 447470, 300);
  EXPECT_NEAR(ring[1][0] - ring[0][0], 68.6, 0.3) << "a thousandth of a degree of longitude there";
}

TEST(Footprints, UnknownCrsAreTakenToBeTheSame) {
  const TemporaryFolder folder;
  const auto path = folder.put("f.geojson", collection({feature(R"("id":1)", kSquare)}));
  const FootprintFile file = read_footprints(path, Crs{});
  EXPECT_FALSE(file.transformed);
  EXPECT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.footprints[0].parts[0][0][0][0], 85000);
  // No CRS means degrees by the standard, but these cannot be degrees.
  const auto bare = folder.put("bare.geojson", collection({feature(R"("id":1)", kSquare)}, ""));
  EXPECT_EQ(read_footprints(bare, crs_from_epsg(28992)).footprints[0].parts[0][0][0][0], 85000);
  const auto degrees =
      folder.put("degrees.geojson",
                 collection({feature("", R"({"type":"Polygon","coordinates":[[[4,52],[5,52],[5,53],[4,52]]]})")}, ""));
  EXPECT_THROW(read_footprints(degrees, Crs{}), Error);
}

TEST(Footprints, FilesThatAreNoneAreUsageErrors) {
  const TemporaryFolder folder;
  for (const auto& path : {folder.path() / "missing.gpkg", folder.put("text.geojson", "hello"),
                           folder.put("empty.geojson", collection({}))}) {
    try {
      read_footprints(path, Crs{});
      FAIL() << path;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::usage);
      EXPECT_NE(std::string(e.what()).find(path.filename().string()), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace ilot
