// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/city_json.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/error.h"

namespace ilot {
namespace {

using nlohmann::json;

// A tetrahedron on its base, with a hole in name only: a ring of the base's own.
Building tetrahedron(const std::string& id, double shift) {
  Building building;
  building.id = id;
  building.vertices = {{100 + shift, 200, 0}, {103 + shift, 200, 0}, {100 + shift, 204, 0}, {100 + shift, 200, 5}};
  building.surfaces = {{SurfaceKind::ground, 0, {{0, 2, 1}}},
                       {SurfaceKind::wall, 0, {{0, 1, 3}}},
                       {SurfaceKind::wall, 7, {{0, 3, 2}}},
                       {SurfaceKind::roof, 8, {{1, 2, 3}}}};
  building.attributes = {{"name", std::string("a \"b\"")}, {"faces", std::int64_t{1}}, {"eave_m", 2.5}};
  return building;
}

class CityJson : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("ilot_city_json_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(CityJson, OneObjectContainsAllBuildings) {
  const auto path = folder_ / "two.city.json";
  CityJsonWriter writer(path, {2154, {100, 200, 0}, 0.001});
  writer.add(tetrahedron("a", 0));
  writer.add(tetrahedron("b", 10.0004));
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.finish();
  std::ifstream file(path);
  const json model = json::parse(file);
  EXPECT_EQ(model["type"], "CityJSON");
  EXPECT_EQ(model["metadata"]["referenceSystem"], "https://www.opengis.net/def/crs/EPSG/0/2154");
  ASSERT_EQ(model["vertices"].size(), 8u);
  EXPECT_EQ(model["vertices"][1], json({3000, 0, 0}));
  EXPECT_EQ(model["vertices"][4], json({10000, 0, 0}));
  const json& b = model["CityObjects"]["b"];
  EXPECT_EQ(b["attributes"]["name"], "a \"b\"");
  EXPECT_EQ(b["attributes"]["eave_m"], 2.5);
  const json& solid = b["geometry"][0];
  EXPECT_EQ(solid["lod"], "2.2");
  EXPECT_EQ(solid["boundaries"], json::parse("[[[[4,6,5]],[[4,5,7]],[[4,7,6]],[[5,6,7]]]]"));
  EXPECT_EQ(solid["semantics"]["surfaces"][2], json::parse(R"({"type":"WallSurface","plane_id":7})"));
  EXPECT_EQ(solid["semantics"]["values"], json::parse("[[0,1,2,3]]"));
}

TEST_F(CityJson, ASequenceHasAFeaturePerLine) {
  const auto path = folder_ / "two.city.jsonl";
  CityJsonWriter writer(path, {0, {100, 200, 0}, 0.001});
  writer.add(tetrahedron("a", 0));
  writer.add(tetrahedron("b", 10));
  writer.finish();
  std::ifstream file(path);
  std::string line;
  std::vector<json> lines;
  while (std::getline(file, line)) lines.push_back(json::parse(line));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["type"], "CityJSON");
  EXPECT_TRUE(lines[0]["CityObjects"].empty());
  EXPECT_FALSE(lines[0].contains("metadata"));
  EXPECT_EQ(lines[2]["type"], "CityJSONFeature");
  EXPECT_EQ(lines[2]["id"], "b");
  EXPECT_EQ(lines[2]["vertices"].size(), 4u);
  EXPECT_EQ(lines[2]["CityObjects"]["b"]["geometry"][0]["boundaries"][0][0][0], json({0, 2, 1}));
}

TEST_F(CityJson, OneBuildingHasSeveralLevels) {
  Building flat = tetrahedron("a", 0), none = tetrahedron("a", 0), solid = tetrahedron("a", 0);
  flat.lod = "0";
  flat.surfaces.resize(1);
  none.surfaces.clear();
  CityJsonWriter writer(folder_ / "a.city.jsonl", {0, {100, 200, 0}, 0.001});
  writer.add(std::vector<Building>{flat, none, solid});
  EXPECT_GT(writer.bytes(), 100u);
  writer.finish();
  std::ifstream file(folder_ / "a.city.jsonl");
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  const json feature = json::parse(line);
  const json& geometry = feature["CityObjects"]["a"]["geometry"];
  ASSERT_EQ(geometry.size(), 2u);
  EXPECT_EQ(geometry[0]["type"], "MultiSurface");
  EXPECT_EQ(geometry[0]["lod"], "0");
  EXPECT_EQ(geometry[0]["boundaries"], json::parse("[[[0,2,1]]]"));
  EXPECT_EQ(geometry[0]["semantics"]["values"], json::parse("[0]"));
  EXPECT_EQ(geometry[1]["type"], "Solid");
  EXPECT_EQ(geometry[1]["boundaries"].size(), 1u);
}

TEST_F(CityJson, NothingStaysWithoutFinishAndFarPlacesAreRefused) {
  {
    CityJsonWriter writer(folder_ / "a.city.json", {});
    writer.add(tetrahedron("a", 0));
    writer.add(tetrahedron("on another continent", 1e7));
    EXPECT_THROW(writer.add(tetrahedron("far", 1e12)), Error);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace ilot
