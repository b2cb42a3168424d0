// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_scan.h"
#include "tests/support/scan_records.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/compare/truth.h"
#include "engine/error.h"
#include "engine/formats/reader.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/echo_point.h"
#include "tests/scan/models/test_models.h"
#include "tests/support/temporary_folder.h"

namespace ilot::scan {
namespace {

struct Given {
  std::vector<std::string> settings;
  bool stations = false, vehicle = false, flight = false;
};

struct Scanned {
  ModelScan scan;
  std::vector<std::byte> records;
  std::vector<std::uint64_t> rays;

  std::size_t points() const { return records.size() / length(); }
  std::size_t length() const { return coloured_layout(scan.grid).record_length; }
  RecordTruth truth(std::size_t i) const { return truth_of(&records[i * length()]); }
  Vec3 place(std::size_t i) const { return place_of(&records[i * length()], coloured_layout(scan.grid)); }
  PointFields fields(std::size_t i) const { return decode_fields({&records[i * length()], 36}, 7); }
  std::size_t of(FaceClass c) const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < points(); ++i) n += truth(i).true_class == static_cast<std::uint8_t>(c);
    return n;
  }
};

ModelScan planned(const Given& given, const std::string& text = test_models::block()) {
  const TemporaryFolder folder;
  ModelInput input;
  input.path = folder.put("a.city.json", text);
  SceneValues values(model_options());
  for (const std::string& s : given.settings) values.set("scene." + s);
  ModelScanners scanners;
  if (given.stations) scanners.stations.emplace();
  if (given.vehicle) scanners.vehicle.emplace();
  scanners.flight = given.flight;
  return plan_model_scan(input, scanners, values, 3);
}

Scanned scanned(const Given& given, std::uint64_t points, int threads = 2) {
  Scanned out{planned(given), {}, {}};
  fit_points(out.scan, points);
  with_threads(threads, [&] {
    out.rays = scan_model(out.scan, [&](std::span<const std::byte> records) {
      out.records.insert(out.records.end(), records.begin(), records.end());
    });
  });
  return out;
}

TEST(ModelScan, PointsLieOnTheirTruePlanes) {
  const Scanned s = scanned({{"noise=0.001", "angle_noise=0"}, true, true, true}, 60000);
  EXPECT_NEAR(static_cast<double>(s.points()), 60000, 3000);
  std::set<std::uint16_t> sources;
  for (std::size_t i = 0; i < s.points(); ++i) {
    sources.insert(s.fields(i).source_id);
    const std::uint32_t id = s.truth(i).true_plane;
    if (id == 0) continue;
    const bool flying = s.fields(i).source_id > 40000, driving = s.fields(i).source_id > 30000;
    const double noise = flying ? 0.02 : driving ? 0.008 : 0.001;
    ASSERT_LE(std::abs(signed_distance(s.scan.stage.planes.at(id - 1).plane, s.place(i))), 6 * noise + 0.001);
  }
  EXPECT_TRUE(sources.contains(1) && sources.contains(30001) && sources.contains(30002));
  EXPECT_GT(*sources.rbegin(), 40000);
  EXPECT_GT(s.of(FaceClass::roof), 0u) << "from the air";
}

TEST(ModelScan, TheSameBytesForAnyNumberOfThreads) {
  const Given all{{}, true, true, true};
  const Scanned one = scanned(all, 20000, 1), four = scanned(all, 20000, 4);
  EXPECT_EQ(one.records, four.records);
  EXPECT_EQ(one.rays, four.rays);
}

TEST(ModelScan, StationsStandBeforeTheWindowsByDefault) {
  const ModelScan scan = planned({});
  ASSERT_FALSE(scan.stations.empty());
  for (const StationParams& s : scan.stations) {
    EXPECT_LT(s.position.y, -4) << "the only window is in the south";
    EXPECT_NEAR(s.position.z, 1.8, 1e-9);
  }
  EXPECT_NE(scan.notes.back().find("678"), std::string::npos) << scan.notes.back();
}

// What a pane does: nothing, an echo of itself, what is behind, or a mirror image.
TEST(ModelScan, PanesGiveWhatIsAsked) {
  const auto with = [](double nothing, double through, double mirrored) {
    return scanned({{fmt::format("glass_nothing={}", nothing), fmt::format("glass_through={}", through),
                     fmt::format("glass_mirrored={}", mirrored), "diameter=0", "divergence=0", "room=0"}},
                   40000);
  };
  const auto on_pane = [](const Scanned& s) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < s.points(); ++i) {
      const Vec3 p = s.place(i);
      n += s.truth(i).true_element == 1 && p.x > 2.1 && p.x < 3.1 && p.z > 1.1 && p.z < 2.4 &&
           std::abs(p.y - 0.1) < 0.02;
    }
    return n;
  };
  const Scanned echo = with(0, 0, 0), nothing = with(1, 0, 0), through = with(0, 1, 0), mirror = with(0, 0, 1);
  EXPECT_GT(on_pane(echo), 100u);
  EXPECT_EQ(on_pane(nothing), 0u);
  EXPECT_EQ(on_pane(through), 0u);
  EXPECT_EQ(on_pane(mirror), 0u);
  EXPECT_EQ(nothing.of(FaceClass::other), 0u);
  EXPECT_GT(nothing.rays.at(1), 100u) << "pulses count without an echo";
  const auto behind = [](const Scanned& s, const auto& is_right) {
    std::size_t n = 0, right = 0;
    for (std::size_t i = 0; i < s.points(); ++i) {
      if (s.truth(i).true_class != static_cast<std::uint8_t>(FaceClass::other)) continue;
      EXPECT_EQ(s.truth(i).true_element, 1u);
      EXPECT_EQ(s.truth(i).true_plane, 0u);
      ++n;
      right += is_right(s.place(i));
    }
    EXPECT_GT(n, 50u);
    EXPECT_EQ(right, n);
  };
  // Through the pane: inside of the walls, roof and floor. In the mirror: the ground before the wall, turned over it.
  behind(through, [](Vec3 p) { return p.y > 0.1 && p.y < 8.1 && p.x > -0.1 && p.x < 10.1 && p.z < 6.1; });
  const Scanned room = scanned({{"glass_nothing=0", "glass_through=1", "room=4", "diameter=0", "divergence=0"}}, 40000);
  std::set<long> depths;
  behind(room, [&](Vec3 p) {
    depths.insert(std::lround(100 * p.y));
    return p.y > 0.1;
  });
  EXPECT_GE(*depths.rbegin(), 200);
  EXPECT_LE(*depths.rbegin(), 612) << "half to one and a half times 4 m, behind the pane";
  behind(mirror, [](Vec3 p) { return p.y > 0.1 && std::abs(p.z) < 0.05; });
}

TEST(ModelScan, IntensitiesScatterByTheirShare) {
  const Scanned without = scanned({{"intensity_noise=0"}}, 20000), with = scanned({{"intensity_noise=0.2"}}, 20000);
  ASSERT_EQ(without.points(), with.points());
  double sum = 0, squares = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < with.points(); ++i) {
    const double a = without.fields(i).intensity, b = with.fields(i).intensity;
    if (a < 1000 || a > 30000) continue;  // neither rounded nor at the end of the scale
    sum += b / a;
    squares += (b / a - 1) * (b / a - 1);
    ++n;
  }
  ASSERT_GT(n, 1000u);
  EXPECT_NEAR(sum / static_cast<double>(n), 1, 0.02);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(n)), 0.2, 0.02);
}

TEST(ModelScan, SharesOfPanesAboveOneAreRefused) {
  EXPECT_THROW(planned({{"glass_nothing=0.9", "glass_through=0.2"}}), Error);
}

// The truth is read back as evaluate reads it.
TEST(ModelScan, WritesATruthThatEvaluateReads) {
  const TemporaryFolder folder;
  ModelInput input;
  input.path = folder.put(
      "a.city.json", test_models::block(false, R"("metadata":{"referenceSystem":"urn:ogc:def:crs:EPSG::32632"},)"));
  ScanRequest request{"", SceneValues(model_options()), 0, 30000, folder.path() / "a.las"};
  ModelScan scan = plan_model_scan(input, {}, request.values, 0);
  write_model_scan(scan, input, request);
  const Truth truth = read_truth(truth_path(request.output));
  ASSERT_EQ(truth.openings.size(), 1u);
  EXPECT_NEAR(truth.openings[0].ring[0].y, 5403000, 1e-3);
  EXPECT_EQ(truth.elements.at(0).kind, "window");
  EXPECT_EQ(truth.buildings.size(), 1u);
  nlohmann::json json;
  std::ifstream(truth_path(request.output)) >> json;
  EXPECT_EQ(json["crs"], "EPSG:32632");
  EXPECT_GT(json["openings"][0]["rays"], 50);
  EXPECT_EQ(json["openings"][0]["flush"], false);
  EXPECT_NEAR(json["planes"][0]["area_m2"].get<double>(), 80, 1e-6);
  const auto reader = open_cloud(request.output);
  EXPECT_EQ(reader->info().crs.epsg, 32632);
  EXPECT_EQ(reader->info().points, json["counts"]["points"]);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a.stations.csv"));
}

}  // namespace
}  // namespace ilot::scan
