// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "scan/scanners/cell_scan.h"
#include "scan/truth_writer.h"

namespace ilot::scan {
namespace {

class DistrictFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("ilot_scan_test_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static DistrictScan plan(std::uint64_t points) { return plan_district(SceneValues(district_options()), 4, points); }

  std::filesystem::path folder_;
};

TEST_F(DistrictFile, CloudAndTruthAgree) {
  const std::filesystem::path path = folder_ / "town.las";
  const ScanSummary summary = write_district(plan(50000), path);
  EXPECT_EQ(summary.points, 50000u);

  const auto reader = open_cloud(path);
  const CloudInfo& info = reader->info();
  ASSERT_EQ(info.points, 50000u);
  EXPECT_EQ(info.crs.epsg, 2154);
  EXPECT_TRUE(info.warnings.empty());
  ASSERT_EQ(info.layout.extra.size(), 2u);
  EXPECT_EQ(info.layout.extra[1].name, "true_plane");
  const std::size_t length = info.layout.record_length;
  std::vector<std::byte> records(info.points * length);
  std::vector<std::uint8_t> valid(info.points);
  ASSERT_EQ(reader->read(0, records, valid), info.points);

  std::ifstream file(truth_path(path));
  const nlohmann::json truth = nlohmann::json::parse(file);
  ASSERT_EQ(truth["planes"].size(), summary.planes);
  EXPECT_EQ(truth["buildings"], summary.buildings);
  std::vector<std::array<double, 4>> planes(summary.planes + 1);
  std::vector<std::uint64_t> declared(summary.planes + 1), counted(summary.planes + 1);
  for (const auto& plane : truth["planes"]) {
    const auto id = plane["id"].get<std::size_t>();
    ASSERT_LE(id, summary.planes);
    planes[id] = plane["plane"];
    declared[id] = plane["points"];
    ASSERT_FALSE(plane["polygons"].empty());
    for (const auto& polygon : plane["polygons"])
      for (const auto& p : polygon["ring"])
        EXPECT_NEAR(planes[id][0] * p[0].get<double>() + planes[id][1] * p[1].get<double>() +
                        planes[id][2] * p[2].get<double>() + planes[id][3],
                    0, 1e-3);
  }
  for (std::size_t i = 0; i < info.points; ++i) {
    const std::byte* record = &records[i * length];
    const std::uint32_t id = true_plane_of(record);
    ASSERT_LE(id, summary.planes);
    if (id == 0) continue;
    ++counted[id];
    const PointFields f = decode_fields({record, 30}, 6);
    const double distance = planes[id][0] * (f.x * 0.001 + kEastOrigin) + planes[id][1] * (f.y * 0.001 + kNorthOrigin) +
                            planes[id][2] * f.z * 0.001 + planes[id][3];
    ASSERT_LT(std::abs(distance), 6 * 0.02 + 0.001);
  }
  EXPECT_EQ(counted, declared);
}

// Every edge of a solid belongs to two faces that run along it in opposite directions.
TEST_F(DistrictFile, HousesAreClosedSolids) {
  const std::filesystem::path path = folder_ / "town.las";
  const ScanSummary summary = write_district(plan(30000), path);
  std::ifstream file(truth_path(path).replace_extension(".city.jsonl"));
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  EXPECT_EQ(nlohmann::json::parse(line)["type"], "CityJSON");
  std::uint64_t houses = 0;
  while (std::getline(file, line)) {
    const nlohmann::json feature = nlohmann::json::parse(line);
    const auto& object = feature["CityObjects"][feature["id"].get<std::string>()];
    ++houses;
    std::map<std::pair<int, int>, int> ways;
    for (const auto& face : object["geometry"][0]["boundaries"][0])
      for (std::size_t i = 0; i < face[0].size(); ++i) ++ways[{face[0][i], face[0][(i + 1) % face[0].size()]}];
    for (const auto& [way, times] : ways) {
      EXPECT_EQ(times, 1);
      EXPECT_EQ((ways.count({way.second, way.first})), 1u) << line;
    }
  }
  EXPECT_EQ(houses, summary.buildings);
}

TEST_F(DistrictFile, LeavesNothingWhenItCannotWrite) {
  EXPECT_THROW(write_district(plan(1000), folder_ / "no" / "such" / "town.las"), Error);
  EXPECT_THROW(write_district(plan(1000), folder_ / "town.xls"), Error);
  // The truth cannot be written where a folder bears its name: then the cloud must not appear either.
  std::filesystem::create_directories(folder_ / "town.truth.json.part");
  EXPECT_THROW(write_district(plan(1000), folder_ / "town.las"), Error);
  std::filesystem::remove(folder_ / "town.truth.json.part");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace ilot::scan
