// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_models.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "engine/error.h"
#include "tests/engine/formats/fixtures.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

constexpr const char* kCubeText =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

std::filesystem::path written(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::vector<ObjectValidity> found_in(const std::filesystem::path& path, ModelsValidity* sum = nullptr) {
  std::vector<ObjectValidity> found;
  const ModelsValidity all = validate_models(path, [&](const ObjectValidity& one) { found.push_back(one); });
  if (sum) *sum = all;
  EXPECT_EQ(all.valid(), found.empty());
  return found;
}

TEST(ValidateModels, CountsObjectsAndCodes) {
  const TemporaryFolder folder;
  ModelsValidity sum;
  const std::string cube = kCubeText;
  const auto file =
      written(folder.path() / "a.obj", "o right\n" + cube + "o open\nf 1 2 3\nf 1 2 3\n" + "o short\nf 1 2\n");
  const auto found = found_in(file, &sum);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].id, "open");
  EXPECT_EQ(codes_of(found[0].faults), std::vector<int>{301});
  EXPECT_EQ(codes_of(found[1].faults), std::vector<int>{101});
  EXPECT_EQ(sum.objects, 3u);
  EXPECT_EQ(sum.invalid, 2u);
  EXPECT_EQ(sum.codes, (std::map<int, std::uint64_t>{{101, 1}, {301, 1}}));
}

TEST(ValidateModels, FilesThatCannotBeReadHaveACode) {
  const TemporaryFolder folder;
  ModelsValidity sum;
  const auto found = found_in(written(folder.path() / "a.off", "OFF\n3 1"), &sum);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(codes_of(found[0].faults), std::vector<int>{901});
  EXPECT_EQ(sum.objects, 0u);
  EXPECT_THROW(found_in(folder.path() / "none.obj"), Error);
  EXPECT_THROW(found_in(written(folder.path() / "a.txt", "")), Error);
}

TEST(ValidateModels, BringsFaultsOfTheFormatTogetherWithTheirObject) {
  const TemporaryFolder folder;
  const auto file =
      written(folder.path() / "a.json",
              R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},"CityObjects":{
        "b":{"type":"Building","children":["p"]},
        "p":{"type":"BuildingPart","parents":["b"],"geometry":[{"type":"Solid","lod":"1","boundaries":[[[[0,1,9]]]]}]},
        "x":{"type":"Castle"}},"vertices":[[0,0,0],[1,0,0],[0,1,0]]})");
  ModelsValidity sum;
  const auto found = found_in(file, &sum);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].id, "b");
  ASSERT_EQ(found[0].format.size(), 1u);
  EXPECT_EQ(found[0].format[0], "geometry 0: boundaries: 9 is none of 3");
  EXPECT_EQ(found[1].format[0], "'Castle' is no type of city object");
  EXPECT_EQ(sum.objects, 2u);
  EXPECT_EQ(sum.invalid, 2u);
  EXPECT_EQ(sum.format_faults, 2u);
}

// A table of what val3dity 2.6 says: a key, 0 or 1, codes.
struct Expected {
  std::string key;
  bool valid;
  std::set<int> codes;
};

std::vector<Expected> expected_of(const std::filesystem::path& csv, std::size_t key_columns) {
  std::ifstream file(csv);
  std::string line;
  std::getline(file, line);
  std::vector<Expected> rows;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string key, skipped, valid, code;
    std::getline(fields, key, ',');
    for (std::size_t i = 1; i < key_columns; ++i) std::getline(fields, skipped, ',');
    std::getline(fields, valid, ',');
    rows.push_back({key, valid == "1", {}});
    while (fields >> code) rows.back().codes.insert(std::stoi(code));
  }
  return rows;
}

std::set<int> codes_in(const std::vector<ObjectValidity>& found) {
  std::set<int> codes;
  for (const ObjectValidity& one : found)
    for (const Fault& fault : one.faults) codes.insert(fault.code);
  return codes;
}

TEST(ValidateModels, AgreesWithVal3dityOnItsOwnTests) {
  ILOT_DATA_OR_SKIP(data);
  const auto rows = expected_of(data / "validity/expected.csv", 2);
  ASSERT_EQ(rows.size(), 100u);
  std::size_t same = 0;
  for (const Expected& row : rows) {
    const auto found = found_in(data / "validity" / row.key);
    EXPECT_EQ(found.empty(), row.valid) << row.key;
    same += codes_in(found) == row.codes ? 1 : 0;
  }
  EXPECT_GE(same, 95u);
  RecordProperty("same_codes", static_cast<int>(same));
}

TEST(ValidateModels, AgreesWithVal3dityOnPublishedModels) {
  ILOT_DATA_OR_SKIP(data);
  const auto rows = expected_of(data / "validity/city3d_east_codes.csv", 1);
  ASSERT_EQ(rows.size(), 554u);
  std::map<std::string, std::set<int>> found;
  for (const ObjectValidity& one : found_in(data / "roofs/city3d/district_east_city3d.obj"))
    found[one.id] = codes_in({one});
  std::size_t agree = 0, same = 0;
  for (const Expected& row : rows) {
    agree += (found.count(row.key) == 0) == row.valid ? 1 : 0;
    same += found[row.key] == row.codes ? 1 : 0;
    if (found[row.key].empty()) found.erase(row.key);
  }
  EXPECT_GE(static_cast<double>(agree), 0.99 * static_cast<double>(rows.size()));
  EXPECT_GE(static_cast<double>(same), 0.95 * static_cast<double>(rows.size()));
  RecordProperty("agree", static_cast<int>(agree));
  RecordProperty("same_codes", static_cast<int>(same));
}

}  // namespace
}  // namespace ilot
