// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/read_area.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

constexpr const char* kSquareWithHole =
    R"({"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]],[[4,4],[6,4],[6,6],[4,6],[4,4]]]})";

std::string fault_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
  return "no fault";
}

TEST(Bounds, CornersInAnyOrderAndClosed) {
  const Area a = parse_bounds("10,-5, 2.5,1e1");
  EXPECT_EQ(a.min_x, 2.5);
  EXPECT_EQ(a.min_y, -5);
  EXPECT_EQ(a.max_x, 10);
  EXPECT_EQ(a.max_y, 10);
  EXPECT_TRUE(a.contains(2.5, -5));
  EXPECT_TRUE(a.contains(10, 10));
  EXPECT_FALSE(a.contains(10.1, 10));
  EXPECT_FALSE(a.contains(std::numeric_limits<double>::quiet_NaN(), 0));
}

TEST(Bounds, Faults) {
  for (const char* text : {"", "1,2,3", "1,2,3,4,5", "1,2,3,x", "1;2;3;4", "1,2,inf,4", "nan,0,1,1", "1,2,1,4"}) {
    EXPECT_EQ(fault_of([&] { parse_bounds(text); }).substr(0, 9), "--bounds ") << text;
  }
}

TEST(ReadArea, GeoJsonWithAHole) {
  const Area a = parse_area(kSquareWithHole, "a.json");
  EXPECT_EQ(a.rings.size(), 2u);
  EXPECT_EQ(a.rings[0].size(), 4u);
  EXPECT_TRUE(a.contains(1, 1));
  EXPECT_FALSE(a.contains(5, 5));
  EXPECT_FALSE(a.contains(11, 5));
}

TEST(ReadArea, WktEqualsGeoJson) {
  const Area a = parse_area(kSquareWithHole, "a.json");
  const Area b = parse_area("POLYGON((0 0,10 0,10 10,0 10,0 0),(4 4,6 4,6 6,4 6,4 4))", "b.wkt");
  const Area c =
      parse_area(" SRID=2154;MultiPolygon Z (((0 0 1, 10 0 1,10 10 1,0 10 1,0 0 1),(4 4 1,6 4 1,6 6 1,4 6 1)))\n", "c");
  EXPECT_EQ(a.rings, b.rings);
  EXPECT_EQ(a.rings, c.rings);
  EXPECT_EQ(c.max_x, 10);
}

TEST(ReadArea, FeaturesAreJoined) {
  const std::string one =
      R"({"type":"Feature","properties":null,"geometry":{"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1]]]]}})";
  const std::string two = R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[5,5],[9,5],[5,9]]]}})";
  const Area a = parse_area(R"({"type":"FeatureCollection","features":[)" + one + "," + two + "]}", "t");
  EXPECT_TRUE(a.contains(0.25, 0.25));
  EXPECT_TRUE(a.contains(6, 6));
  EXPECT_FALSE(a.contains(3, 3));
  EXPECT_EQ(a.max_y, 9);
}

TEST(ReadArea, NeighboursShareNoPoint) {
  const Area left = parse_area("POLYGON((0 0,3 1,2 7,0 7))", "l");
  const Area right = parse_area("POLYGON((3 1,9 0,9 7,2 7))", "r");
  for (int i = 0; i <= 600; ++i) {
    const double y = 1 + 0.01 * i;
    const double x = 3 - (y - 1) / 6;
    EXPECT_FALSE(left.contains(x, y) && right.contains(x, y)) << y;
  }
}

TEST(ReadArea, Faults) {
  for (const char* text : {"",
                           "{}",
                           "{",
                           "POINT(1 2)",
                           "POLYGON",
                           "POLYGON((",
                           "POLYGON((0 0,1 1))",
                           "POLYGON((0 0,1 0,1 1,0 0)",
                           "[1,2]",
                           "POLYGON((0 0,1 0,1 nan))",
                           "POLYGON((0 0,1 0,1 1)) x",
                           "POLYGON M ((0 0 1,1 0 1,1 1 1))",
                           R"({"type":"Point","coordinates":[1,2]})",
                           R"({"type":"Polygon","coordinates":[]})",
                           R"({"type":"Polygon","coordinates":[[[0,0],[1],[1,1]]]})",
                           R"({"type":"Polygon","coordinates":[[1,2,3]]})",
                           R"({"type":"Polygon","coordinates":[[[0,0],[1e999,1],[1,1]]]})",
                           R"({"type":7})",
                           R"({"type":"Feature","geometry":null})",
                           R"({"type":"Polygon","coordinates":"x"})"}) {
    EXPECT_EQ(fault_of([&] { parse_area(text, "a.json"); }).substr(0, 8), "a.json: ") << text;
  }
  EXPECT_EQ(fault_of([] { read_area("/nonexistent.json"); }),
            "/nonexistent.json: cannot read the area: No such file or directory");
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += R"({"type":"Feature","geometry":)";
  EXPECT_EQ(fault_of([&] { parse_area(deep + "null" + std::string(100, '}'), "d"); }),
            "d: collections nest too deeply");
}

TEST(ReadArea, FromAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_area(folder.put("a.geojson", kSquareWithHole)).max_x, 10);
}

}  // namespace
}  // namespace ilot
