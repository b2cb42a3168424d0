// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/make_roofs.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "engine/error.h"
#include "engine/model/point_label.h"
#include "engine/run/run.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using nlohmann::json;

// Two houses that share a wall, a third alone, level ground around them, and further points without a class;
// millimetres.
struct Village {
  TemporaryFolder folder;
  std::filesystem::path cloud, footprints;

  explicit Village(std::span<const Index3> without_class = {}) {
    Rng rng(21);
    std::vector<Index3> points;
    std::vector<std::uint8_t> classes;
    const auto noise = [&] { return static_cast<std::int64_t>(rng.below(41)) - 20; };
    for (std::int64_t x = 0; x < 60000; x += 330) {
      for (std::int64_t y = 0; y < 30000; y += 330) {
        const std::int64_t px = 84000000 + x + noise(), py = 447000000 + y + noise();
        const bool in_row = y >= 10000 && y < 20000;
        const std::int64_t z = in_row && x >= 10000 && x < 20000   ? 6000
                               : in_row && x >= 20000 && x < 30000 ? 9000 - (y - 10000) / 4
                               : in_row && x >= 40000 && x < 52000 ? 7500
                                                                   : 1000;
        points.push_back({px, py, z + noise()});
        classes.push_back(z > 1000 ? 6 : 2);
      }
    }
    points.insert(points.end(), without_class.begin(), without_class.end());
    classes.resize(points.size(), 1);
    cloud = folder.path() / "village.las";
    test::write_cloud(cloud, points, classes);
    footprints = folder.put("village.geojson", text());
  }

  static std::string box(const std::string& id, double x0, double y0, double x1, double y1) {
    std::ostringstream out;
    out.precision(12);
    const auto p = [&](double x, double y) { out << "[" << 84000 + x << "," << 447000 + y << "]"; };
    out << R"({"type":"Feature","properties":{"id":")" << id << R"("},"geometry":{"type":"Polygon","coordinates":[[)";
    p(x0, y0), out << ",", p(x1, y0), out << ",", p(x1, y1), out << ",", p(x0, y1), out << ",", p(x0, y0);
    out << "]]}}";
    return out.str();
  }

  static std::string text() {
    return collection({box("10", 40, 10, 52, 20), box("2", 20, 10, 30, 20), box("1", 10, 10, 20, 20),
                       box("far", 500, 500, 510, 510), box("line", 12, 12, 12, 18)});
  }

  static std::string collection(const std::vector<std::string>& boxes) {
    std::string all;
    for (const std::string& b : boxes) all += (all.empty() ? "" : ",") + b;
    return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::28992"}},"features":[)" +
           all + "]}";
  }
};

struct RoofsOutcome {
  int code = 0;
  json record;
  std::map<std::string, json> buildings;  // features by id
  std::vector<std::string> ids;           // in the order of the file
  std::string sequence;
};

std::string text_of(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

RoofsOutcome run_village(const Village& village, const std::string& name,
                         const std::function<void(RunOptions&)>& change = {}) {
  RunOptions options;
  options.inputs = {village.cloud};
  options.output = village.folder.path() / name;
  options.products = {"roofs"};
  options.footprints = village.footprints;
  options.crs = "EPSG:28992";
  options.threads = 2;
  if (change) change(options);
  Progress progress;
  RoofsOutcome out;
  out.code = run(options, progress);
  out.record = json::parse(text_of(options.output / "run.json"));
  out.sequence = text_of(options.output / "roofs" / "roofs.city.jsonl");
  std::istringstream lines(out.sequence);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    out.buildings[json::parse(line)["id"]] = json::parse(line);
    out.ids.push_back(json::parse(line)["id"]);
  }
  return out;
}

double attribute(const RoofsOutcome& out, const std::string& id, const char* name) {
  return out.buildings.at(id)["CityObjects"][id]["attributes"][name];
}

TEST(RoofsProduct, EveryFootprintComesBack) {
  const Village village;
  const RoofsOutcome out = run_village(village, "out");
  EXPECT_EQ(out.code, static_cast<int>(ExitCode::incomplete));
  EXPECT_EQ(out.ids, (std::vector<std::string>{"1", "2", "10", "far", "line"}));
  const json counts = out.record["counts"]["roofs"];
  EXPECT_EQ(counts["buildings"], 5);
  EXPECT_EQ(counts["lod22"], 3);
  EXPECT_EQ(counts["footprint_only"], 2);
  EXPECT_EQ(out.record["footprints"]["without_outline"], 1);
  ASSERT_EQ(out.record["skipped"].size(), 1u);
  EXPECT_EQ(out.record["skipped"][0]["where"], "line");
  EXPECT_NE(out.record["skipped"][0]["reason"], "");
  EXPECT_EQ(out.record["footprints"]["outside"], json::array({"far"})) << "no fault";
  for (const char* id : {"1", "2", "10"}) {
    EXPECT_NEAR(attribute(out, id, "h_ground"), 1, 0.03) << id;
    EXPECT_EQ(out.buildings.at(id)["CityObjects"][id]["attributes"]["ground_source"], "measured");
    EXPECT_LT(attribute(out, id, "rmse_m"), 0.03) << id;
    EXPECT_GT(attribute(out, id, "coverage"), 0.95) << id;
  }
  EXPECT_NEAR(attribute(out, "1", "h_roof_max"), 6, 0.03);
  EXPECT_NEAR(attribute(out, "2", "h_roof_max"), 9, 0.11) << "a row of points lies up to 33 cm below the eave";
  EXPECT_NEAR(attribute(out, "10", "h_roof_50"), 7.5, 0.03);
  EXPECT_EQ(out.buildings.at("far")["CityObjects"]["far"]["geometry"][0]["type"], "MultiSurface");
  EXPECT_EQ(out.buildings.at("line")["CityObjects"]["line"]["geometry"], json::array());
}

TEST(RoofsProduct, NothingDependsOnThreadsOrBlocks) {
  const Village village;
  const RoofsOutcome out = run_village(village, "out");
  for (const int threads : {1, 3}) {
    for (const std::uint64_t block_points : {256u, 5000u}) {
      const std::string name = "out" + std::to_string(threads) + "-" + std::to_string(block_points);
      const RoofsOutcome again = run_village(village, name, [&](RunOptions& o) {
        o.threads = threads;
        o.settings.index.block_points = block_points;
      });
      EXPECT_EQ(again.record["result_hash"], out.record["result_hash"]) << name;
    }
  }
}

TEST(RoofsProduct, ABuildingAloneIsThatOfTheWhole) {
  const Village village;
  const RoofsOutcome out = run_village(village, "out");
  const RoofsOutcome part = run_village(village, "part", [](RunOptions& o) {
    o.area = Area{84015, 447005, 84025, 447015, {}};
  });
  ASSERT_EQ(part.ids, (std::vector<std::string>{"2"}));
  const json& whole = out.buildings.at("2");
  EXPECT_EQ(part.buildings.at("2")["vertices"], whole["vertices"]);
  json alone = part.buildings.at("2")["CityObjects"]["2"]["attributes"],
       of_whole = whole["CityObjects"]["2"]["attributes"];
  alone.erase("unit_id");
  of_whole.erase("unit_id");
  EXPECT_EQ(alone, of_whole);
  EXPECT_EQ(part.buildings.at("2")["CityObjects"]["2"]["geometry"].back()["boundaries"],
            whole["CityObjects"]["2"]["geometry"].back()["boundaries"]);
}

// The text of a building without the numbers that count buildings and planes of the run.
std::string without_numbers(json feature) {
  for (auto& [id, object] : feature["CityObjects"].items()) {
    for (const char* of_run : {"unit_id", "party_wall_m2", "exterior_wall_m2"}) object["attributes"].erase(of_run);
    for (json& geometry : object["geometry"]) {
      if (!geometry.contains("semantics")) continue;
      for (json& surface : geometry["semantics"]["surfaces"]) surface.erase("plane_id");
    }
  }
  return feature.dump();
}

// Neighbours that touch, outlines drawn beside the walls, a sliver between two of them, one twice, one over two others.
TEST(RoofsProduct, AChoiceOfFootprintsGivesTheBuildingsOfAllOfThem) {
  const Village village;
  const std::vector<std::string> all{
      Village::box("low", 10, 10, 19.7, 20),      Village::box("sliver", 19.7, 10, 20.2, 20),
      Village::box("high", 20.2, 10, 30, 20),     Village::box("twin", 20.2, 10, 30, 20),
      Village::box("both", 12, 12, 28, 18),       Village::box("hall", 40, 10, 46, 20),
      Village::box("beside", 46.3, 10, 52.4, 20), Village::box("yard", 30.3, 10, 39.8, 20)};
  const auto run_with = [&](const std::string& name, const std::vector<std::string>& boxes) {
    const auto path = village.folder.put(name + ".geojson", Village::collection(boxes));
    return run_village(village, name, [&](RunOptions& o) { o.footprints = path; });
  };
  const RoofsOutcome whole = run_with("whole", all);
  ASSERT_EQ(whole.buildings.size(), all.size());
  EXPECT_EQ(whole.record["footprints"]["overlapping"], 5);
  Rng rng(26);
  for (int n = 0; n < 10; ++n) {
    std::vector<std::string> some;
    for (const std::string& b : all)
      if (rng.below(2) == 0) some.push_back(b);
    if (some.empty()) some.push_back(all[rng.below(all.size())]);
    const RoofsOutcome part = run_with("part" + std::to_string(n), some);
    EXPECT_EQ(part.buildings.size(), some.size());
    for (const auto& [id, feature] : part.buildings)
      EXPECT_EQ(without_numbers(feature), without_numbers(whole.buildings.at(id))) << "choice " << n << ", " << id;
  }
}

TEST(RoofsProduct, PointsBesideAnOutlineWithoutABuildingPointHaveNoFace) {
  std::vector<Index3> hedge;
  for (std::int64_t y = 2000; y < 6000; y += 200) hedge.push_back({84058200, 447000000 + y, 4000});
  const Village village(hedge);
  const auto path = village.folder.put("yard.geojson", Village::collection({Village::box("yard", 54, 2, 58, 6)}));
  const RoofsOutcome out = run_village(village, "out", [&](RunOptions& o) { o.footprints = path; });
  ASSERT_EQ(out.ids, std::vector<std::string>{"yard"});
  EXPECT_EQ(out.record["counts"]["roofs"]["footprint_only"], 1);
  EXPECT_EQ(out.buildings.at("yard")["CityObjects"]["yard"]["attributes"]["reason"],
            "none of the points in its outline is a building's");
}

// Rows of a flight a metre apart over a gable, and walls whose rows have a point every 3 cm: most points are the
// walls'.
TEST(RoofsProduct, DenseWallsDoNotHideTheRoof) {
  const Village village;
  Rng rng(5);
  std::vector<Index3> points;
  const auto noise = [&] { return static_cast<std::int64_t>(rng.below(41)) - 20; };
  const auto add = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    points.push_back({84000000 + x + noise(), 447000000 + y + noise(), z + noise()});
  };
  for (std::int64_t x = 0; x <= 16000; x += 1000) {
    for (std::int64_t y = 0; y <= 12000; y += 500) add(x, y, 6000 + std::min(y, 12000 - y) / 2);
    for (const std::int64_t y : {0, 12000})
      for (std::int64_t z = 3000; z < 6000; z += 30) add(x, y, z);
  }
  const auto cloud = village.folder.path() / "walls.las";
  test::write_cloud(cloud, points, std::vector<std::uint8_t>(points.size(), 6));
  const RoofsOutcome out = run_village(village, "out", [&](RunOptions& o) {
    o.inputs = {cloud};
    o.footprints.clear();
  });
  ASSERT_EQ(out.ids.size(), 1u);
  EXPECT_EQ(out.record["counts"]["roofs"]["lod22"], 1);
  EXPECT_NEAR(attribute(out, out.ids[0], "h_roof_max"), 9, 0.2);
  EXPECT_NEAR(attribute(out, out.ids[0], "area_m2"), 16 * 12, 10);
}

TEST(RoofsProduct, PointsKnowTheirBuildingFaceAndLabel) {
  const Village village;
  const RoofsOutcome out = run_village(village, "out");
  const auto reader = open_cloud(village.folder.path() / "out" / "points" / "village.laz");
  const RecordLayout& layout = reader->info().layout;
  std::vector<std::byte> rows(reader->info().points * layout.record_length);
  std::vector<std::uint8_t> valid(reader->info().points);
  ASSERT_EQ(reader->read(0, rows, valid), valid.size());
  const auto offset = [&](const char* name) {
    for (const ExtraField& f : layout.extra)
      if (f.name == name) return f.offset;
    ADD_FAILURE() << name;
    return std::uint16_t{0};
  };
  const auto plane_at = offset("plane_id"), unit_at = offset("unit_id"), label_at = offset("label");
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const std::byte* row = rows.data() + i * layout.record_length;
    const double x = load<std::int32_t>(row) * 0.001 - 84000;
    const PointFields f = decode_fields({row, 20}, layout.point_format);
    const auto plane = load<std::uint32_t>(row + plane_at), unit = load<std::uint32_t>(row + unit_at);
    const int label = static_cast<int>(load<std::uint8_t>(row + label_at));
    labelled += label != 0;
    if (f.classification == 2) {
      EXPECT_EQ(label, static_cast<int>(PointLabel::ground));
      EXPECT_EQ(unit, 0u);
      continue;
    }
    if (std::abs(x - 20) > 0.1) {
      EXPECT_EQ(unit, x < 20 ? 1u : x < 35 ? 2u : 3u) << "ids in order: 1, 2, 10";
    }
    EXPECT_EQ(plane != 0, label == static_cast<int>(PointLabel::roof));
  }
  EXPECT_EQ(out.record["counts"]["points"]["labelled"], labelled);
}

}  // namespace
}  // namespace ilot
