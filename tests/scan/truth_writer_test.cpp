// SPDX-License-Identifier: Apache-2.0
#include "scan/truth_writer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/error.h"
#include "scan/scanners/scan_record.h"
#include "tests/support/temporary_folder.h"

namespace ilot::scan {
namespace {

nlohmann::json read(const std::filesystem::path& path) {
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

TEST(TruthWriter, WritesTheSchemaWhateverTheOrderOfItems) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.truth.json";
  TruthWriter truth(path, R"("scene":"test","seed":7)");
  truth.noise({0.004, 0.003, 0.2, 0.005});
  truth.classes({{1, "facade"}, {2, "sill"}});
  truth.materials({{1, "limestone"}});
  const TruePolygon polygon{0, {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}}, {{{1, 0, 1}, {2, 0, 1}, {2, 0, 2}}}};
  truth.add(TruePlane{1, "facade", {{0, -1, 0}, 0}, 12, 0, {polygon}});
  truth.add(TrueElement{
      5, "window", 1, 2, 3, {{1, 0, 1}, {2, 0, 1}, {2, 0, 2}}, {{{1.5, 0, 2}, 0.5, 0, 180}}, 1, 1, -0.25, 3});
  truth.add(TruePlane{2, "sill", {{0, 0, 1}, -1}, 3, 5, {}});
  truth.add(TrueStation{1, {-3, -12, 1.6}, 0.03, 0.02});
  truth.add(TrueShape{3, "cylinder", {0, 1, 0}, {0, 0, 1}, 0.4, 0, 2, 99});
  truth.add(TrueOpening{1, 5, 1, {{1, 0, 1}, {2, 0, 1}, {2, 0, 2}}});
  truth.add(TrueControlPoint{"window_top", 5, {1, 0, 2}});
  truth.add(TrueBuilding{1, "gable", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {1, 2}, 5, 8, 0});
  truth.add(TrueObject{1, "van", "panel_van", "car", {0, 0, 0}, {0, 0, 1}, {4, 2, 2}, 30, {2}, 40});
  truth.add(TrueBlock{1, "left", {0, 0, 0}, {50, 0, 0}});
  truth.finish({{"points", 15}, {"planes", 2}});

  const nlohmann::json json = read(path);
  EXPECT_EQ(json["scan"]["seed"], 7);
  EXPECT_EQ(json["crs"], "EPSG:2154");
  EXPECT_EQ(json["noise"]["range_m"], 0.004);
  EXPECT_EQ(json["classes"]["2"], "sill");
  EXPECT_EQ(json["materials"]["1"], "limestone");
  ASSERT_EQ(json["planes"].size(), 2u);
  EXPECT_EQ(json["planes"][1]["element"], 5);
  EXPECT_EQ(json["planes"][0]["polygons"][0]["holes"][0].size(), 3u);
  // World coordinates: the plane holds its own ring.
  const auto plane = json["planes"][0]["plane"].get<std::array<double, 4>>();
  for (const auto& p : json["planes"][0]["polygons"][0]["ring"])
    EXPECT_NEAR(
        plane[0] * p[0].get<double>() + plane[1] * p[1].get<double>() + plane[2] * p[2].get<double>() + plane[3], 0,
        1e-6);
  EXPECT_EQ(json["elements"][0]["arcs"][0]["to_deg"], 180);
  EXPECT_EQ(json["elements"][0]["depth_m"], -0.25);
  EXPECT_DOUBLE_EQ(json["stations"][0]["position"][0], kEastOrigin - 3);
  EXPECT_EQ(json["shapes"][0]["radius_m"], 0.4);
  EXPECT_FALSE(json["shapes"][0].contains("half_angle_deg"));
  EXPECT_EQ(json["openings"][0]["element"], 5);
  EXPECT_EQ(json["control_points"][0]["group"], "window_top");
  EXPECT_EQ(json["buildings"][0]["faces"], nlohmann::json({1, 2}));
  EXPECT_EQ(json["objects"][0]["box"]["size"][0], 4);
  EXPECT_EQ(json["blocks"][0]["side"], "left");
  EXPECT_EQ(json["counts"]["points"], 15);
  EXPECT_FALSE(json.contains("trajectory"));
}

TEST(TruthWriter, LongListsComeWholeAndLeaveNoFileBehind) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.truth.json";
  {
    TruthWriter truth(path, R"("scene":"test")");
    for (std::uint32_t id = 1; id <= 30000; ++id) {
      truth.add(TruePlane{id, "roof", {{0, 0, 1}, 0}, id, 0, {}});
      truth.add(TrueControlPoint{"window_top", id, {0, 0, 0}});
    }
    truth.finish({});
  }
  const nlohmann::json json = read(path);
  ASSERT_EQ(json["planes"].size(), 30000u);
  EXPECT_EQ(json["planes"][29999]["id"], 30000);
  EXPECT_EQ(json["control_points"].size(), 30000u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(TruthWriter, NothingStaysWithoutFinish) {
  const TemporaryFolder folder;
  {
    TruthWriter truth(folder.path() / "a.truth.json", "");
    truth.add(TrueStation{});
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(TruthWriter(folder.path() / "no" / "a.truth.json", ""), Error);
}

}  // namespace
}  // namespace ilot::scan
