// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/footprints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

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
              R"({"type":"Polygon","coordinates":[[[4.36,52.012],[4.361,52.012],[4.361,52.0125],[4.36,52.012]]]})")},
          ""));
  const FootprintFile file = read_footprints(path, crs_from_epsg(28992));
  EXPECT_TRUE(file.transformed);
  EXPECT_EQ(file.id_attribute, "");
  EXPECT_EQ(file.footprints[0].id, "1");
  // Computed without PROJ by the formulas of IOGP's guidance note 7-2: EPSG:4833 backwards (coordinate frame rotation)
  // and the oblique stereographic projection EPSG:19914 on Bessel's ellipsoid. The other sets of parameters that EPSG
  // has for this change of datum, 1672 and 9281, give places at most a centimetre from these.
  const double expected[3][2]{{84480.4288, 447569.3459}, {84549.0776, 447568.3755}, {84549.8635, 447624.0005}};
  const auto& ring = file.footprints[0].parts.at(0).at(0);
  ASSERT_EQ(ring.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis) EXPECT_NEAR(ring[i][axis], expected[i][axis], 0.1) << i;
}

// Length in metres of the meridian of WGS 84 from the equator to a latitude, by Simpson's rule. The integrand's fourth
// derivative is below 1, so the error is below 6.4e6 m * h^4 / 180 = 1e-11 m at steps of h = 5e-5.
double meridian_arc(double degrees) {
  constexpr double kAxis = 6378137, kFlattening = 1 / 298.257223563;
  constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
  constexpr int kSteps = 20000;
  const double h = degrees * std::numbers::pi / 180 / kSteps;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = std::sin(i * h);
    sum += (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * std::pow(1 - kEccentricity2 * s * s, -1.5);
  }
  return kAxis * (1 - kEccentricity2) * h / 3 * sum;
}

// On the central meridian of a UTM zone x is 500 km and y the meridian's arc at the scale 0.9996, by definition.
TEST(Footprints, DegreesOnAMeridianBecomeItsArc) {
  const TemporaryFolder folder;
  const std::string square = R"({"type":"Polygon","coordinates":[[[3,48],[3.001,48],[3,52],[3,48]]]})";
  const auto path = folder.put("meridian.geojson", collection({feature("", square)}, ""));
  const FootprintFile file = read_footprints(path, crs_from_epsg(32631));
  const auto& ring = file.footprints[0].parts.at(0).at(0);
  ASSERT_EQ(ring.size(), 3u);
  for (const auto& [i, latitude] : {std::pair<std::size_t, double>{0, 48}, std::pair<std::size_t, double>{2, 52}}) {
    EXPECT_NEAR(ring[i][0], 500000, 1e-6);
    EXPECT_NEAR(ring[i][1], 0.9996 * meridian_arc(latitude), 1e-6) << "series and sums are right to a micrometre";
  }
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
