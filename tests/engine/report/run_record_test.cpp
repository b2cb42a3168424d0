// SPDX-License-Identifier: Apache-2.0
#include "engine/report/run_record.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/settings/config.h"
#include "engine/version.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

RunRecord example() {
  RunRecord r;
  r.exit = ExitCode::incomplete;
  r.settings.planes.epsilon = 0.02;
  r.products = {"planes"};
  r.threads = 2;
  r.inputs = {{"a.las", "las", "EPSG:2154", 90, 4000, "points/a.laz", ""}};
  r.stages = {{"index", 2, 3, 100}, {"planes", 0, 0, 0}};
  r.peak_rss_bytes = 1 << 20;
  r.blocks = 4;
  r.points = {100, 60, 30, {{"not finite", 7}, {"withheld", 3}}};
  r.planes = 12;
  r.skipped = {{"input", "b.las", "0 points"}};
  r.chosen = {{"planes.min_points", 40.0, "sampling step 0.2 m"}, {"planes.method", std::string("ransac"), "flat"}};
  r.unit_assumed = true;
  r.request = R"({"crs":"EPSG:2154"})";
  r.results = {{"planes.csv", 7}, {"points/caf\xE9.laz", 9}};
  r.result_hash = "ab";
  return r;
}

TEST(RunRecord, HasTheNamesThatScriptsRelyOn) {
  const auto j = nlohmann::json::parse(run_json(example()));
  EXPECT_EQ(j["version"], version());
  EXPECT_EQ(j["git_hash"], git_hash());
  EXPECT_EQ(j["exit_code"], 3);
  EXPECT_EQ(j["parameters"]["planes.epsilon"], 0.02);
  EXPECT_EQ(j["parameters"]["planes.min_points"], "auto");
  EXPECT_EQ(j["parameters_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(j["inputs"][0]["path"], "a.las");
  EXPECT_EQ(j["inputs"][0]["output"], "points/a.laz");
  EXPECT_EQ(j["request"]["crs"], "EPSG:2154");
  EXPECT_EQ(j["results"][0]["bytes"], 7);
  EXPECT_EQ(j["results"][1]["path"], "points/caf\\xE9.laz");
  EXPECT_EQ(j["stages"][0]["name"], "index");
  EXPECT_EQ(j["stages"][0]["seconds"], 2);
  EXPECT_EQ(j["stages"][0]["cpu_seconds"], 3);
  EXPECT_EQ(j["stages"][0]["points"], 100);
  EXPECT_EQ(j["stages"][0]["points_per_second"], 50);
  EXPECT_EQ(j["stages"][1]["points_per_second"], 0);
  EXPECT_EQ(j["peak_rss_bytes"], 1 << 20);
  EXPECT_EQ(j["blocks"], 4);
  EXPECT_EQ(j["counts"]["points"]["read"], 100);
  EXPECT_EQ(j["counts"]["points"]["labelled"], 60);
  EXPECT_EQ(j["counts"]["points"]["unlabelled"], 30);
  EXPECT_EQ(j["counts"]["points"]["rejected"], 10);
  EXPECT_EQ(j["counts"]["planes"], 12);
  EXPECT_EQ(j["rejected"]["not finite"], 7);
  EXPECT_EQ(j["skipped"][0]["what"], "input");
  EXPECT_EQ(j["skipped"][0]["where"], "b.las");
  EXPECT_EQ(j["skipped"][0]["reason"], "0 points");
  EXPECT_EQ(j["chosen"][0]["key"], "planes.min_points");
  EXPECT_EQ(j["chosen"][0]["value"], 40);
  EXPECT_EQ(j["chosen"][1]["value"], "ransac");
  EXPECT_EQ(j["unit_assumed"], true);
  EXPECT_EQ(j["result_hash"], "ab");
}

TEST(RunRecord, EmptyListsAreLists) {
  const auto j = nlohmann::json::parse(run_json(RunRecord{}));
  for (const char* key : {"inputs", "stages", "skipped", "chosen", "warnings", "products"}) {
    EXPECT_TRUE(j[key].is_array()) << key;
  }
  EXPECT_TRUE(j["rejected"].is_object());
  EXPECT_FALSE(j["counts"].contains("planes"));
}

TEST(RunRecord, IsWrittenWholeAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_run_json(example(), folder.path());
  std::ifstream file(folder.path() / "run.json");
  EXPECT_EQ(nlohmann::json::parse(file)["blocks"], 4);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(write_run_json(example(), folder.path() / "none"), Error);
}

}  // namespace
}  // namespace ilot
