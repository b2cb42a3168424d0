// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_scan.h"
#include "tests/support/scan_records.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/scan_record.h"
#include "scan/truth_writer.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kStreetRecord = 45;

StreetScan plan_street(std::initializer_list<const char*> settings, std::uint64_t seed = 0) {
  SceneValues values(street_options());
  for (const char* setting : settings) values.set(setting);
  return plan_street_scan(values, seed);
}

std::vector<std::byte> records_of(const StreetScan& scan, const StreetStage& stage, int threads) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_street(scan, stage,
                [&](std::span<const std::byte> records) { all.insert(all.end(), records.begin(), records.end()); });
  });
  return all;
}

TEST(StreetScan, SameBytesForAnyNumberOfThreads) {
  StreetScan scan = plan_street({"scene.blocks=2", "scene.profiles=2", "scene.step=1"});
  const StreetStage stage = set_stage(scan);
  const std::vector<std::byte> one = records_of(scan, stage, 1);
  EXPECT_GT(one.size() / kStreetRecord, 50000u);
  for (int threads : {2, 3}) EXPECT_TRUE(records_of(scan, stage, threads) == one) << threads;
}

TEST(StreetScan, AboutAsManyPointsAsAskedFor) {
  StreetScan scan = plan_street({"scene.blocks=3"});
  const StreetStage stage = set_stage(scan);
  for (std::uint64_t points : {50000u, 400000u}) {
    StreetScan fitted = scan;
    fit_points(fitted, stage, points);
    const auto n = static_cast<double>(records_of(fitted, stage, 2).size() / kStreetRecord);
    EXPECT_NEAR(n, static_cast<double>(points), 0.02 * static_cast<double>(points));
    // Both spacings are scaled alike.
    EXPECT_NEAR(fitted.drive.profiles * fitted.drive.step_deg, scan.drive.profiles * scan.drive.step_deg, 1e-9);
  }
}

// On a bare stretch of road the points of one head lie as far apart as the profiles and the step say.
TEST(StreetScan, ProfilesAndPulsesAreSpacedAsAskedFor) {
  StreetScan scan = plan_street({"scene.blocks=1", "scene.profiles=4", "scene.step=0.5", "scene.noise=0",
                                 "scene.slope=0", "scene.trees=0", "scene.turned=0"});
  const StreetStage stage = set_stage(scan);
  std::map<int, std::vector<Vec3>> turns;  // of head 1, by profile
  const std::vector<std::byte> records = records_of(scan, stage, 2);
  const RecordLayout layout = coloured_layout(0.001);
  for (std::size_t at = 0; at < records.size(); at += kStreetRecord) {
    const PointFields f = decode_fields({&records[at], 36}, 7);
    const Vec3 p = scene_to_street(place_of(&records[at], layout));
    // Right below: the road ahead of the first block.
    if (f.source_id == 1 && p.x < 9 && std::abs(f.scan_angle_deg) > 150)
      turns[static_cast<int>(std::floor(p.x * 4))].push_back(p);
  }
  ASSERT_GT(turns.size(), 25u);
  for (const auto& [turn, points] : turns) {
    ASSERT_GT(points.size(), 50u);
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (std::abs(points[i].y - points[i - 1].y) > 0.5) continue;  // across the vehicle
      const double depth = 2.6, t0 = points[i - 1].y + 1.6, t1 = points[i].y + 1.6;
      const double degrees = std::abs(std::atan2(t1, depth) - std::atan2(t0, depth)) * 57.29577951308232;
      EXPECT_NEAR(degrees, 0.5, 0.06);
      EXPECT_NEAR(points[i].x - points[i - 1].x, 0.25 * 0.5 / 360, 0.0025);  // the vehicle goes on
    }
  }
}

class SparseStreet : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scan_ = plan_street({"scene.profiles=4", "scene.step=0.8"});
    stage_ = set_stage(scan_);
    records_ = records_of(scan_, stage_, 2);
  }
  static void TearDownTestSuite() {
    records_ = {};
    stage_ = {};
  }
  static StreetScan scan_;
  static StreetStage stage_;
  static std::vector<std::byte> records_;
};
StreetScan SparseStreet::scan_;
StreetStage SparseStreet::stage_;
std::vector<std::byte> SparseStreet::records_;

TEST_F(SparseStreet, EveryObjectAndEveryClassHasPoints) {
  std::vector<int> on_object(stage_.objects.size() + 1);
  std::map<int, int> of_class;
  for (std::size_t at = 0; at < records_.size(); at += kStreetRecord) {
    const RecordTruth t = truth_of(&records_[at]);
    ++on_object[t.true_element];
    ++of_class[t.true_class];
    if (t.true_element > 0) {
      EXPECT_EQ(t.true_class, static_cast<int>(class_of(stage_.objects[t.true_element - 1].artefact_class)));
    }
  }
  for (const StreetObject& o : stage_.objects) EXPECT_GT(on_object[o.id], 0) << o.variant << " " << o.id;
  EXPECT_EQ(of_class.size(), 8u);
}

TEST_F(SparseStreet, PointsLieOnTheirPlanesAndInTheirBoxes) {
  const RecordLayout layout = coloured_layout(0.001);
  for (std::size_t at = 0; at < records_.size(); at += kStreetRecord) {
    const RecordTruth t = truth_of(&records_[at]);
    const Vec3 p = scene_to_street(place_of(&records_[at], layout));
    if (t.true_plane > 0) {
      ASSERT_LT(std::abs(signed_distance(stage_.model.planes[t.true_plane - 1].plane, p)), 6 * 0.008 + 0.002);
    }
    if (t.true_element == 0) continue;
    const StreetObject& o = stage_.objects[t.true_element - 1];
    const PlanBox grain{p.x, p.y, {}, 0, 0};
    ASSERT_TRUE(closer(o.plan, grain, 6 * 0.008 + 0.002)) << o.variant;
    ASSERT_LT(p.z, o.pose.base.z + o.box.max.z + 0.05);
  }
}

// Houses are closed: what is seen of them lies on their outside, and nothing behind it.
TEST_F(SparseStreet, NoRayPassesThroughAWall) {
  const RecordLayout layout = coloured_layout(0.001);
  int beside = 0;
  for (std::size_t at = 0; at < records_.size(); at += kStreetRecord) {
    const Vec3 p = scene_to_street(place_of(&records_[at], layout));
    const double out = std::abs(p.y), skin = 6 * 0.008 + 0.002;
    if (out < kHalfStreet + kReveal + skin || out > kHalfStreet + kHouseDepth - skin) continue;
    for (const StreetHouse& house : stage_.street.houses) {
      if (house.side * p.y < 0 || p.x < house.from + skin || p.x > house.to - skin) continue;
      ASSERT_GT(p.z, house.eave() - skin) << p.x << " " << p.y;
    }
    ++beside;
  }
  EXPECT_GT(beside, 1000);  // roofs, end walls, cross streets
}

TEST_F(SparseStreet, CullingLosesNothing) {
  const PartScene scene(stage_.model.scene.parts);
  Rng rng(9);
  for (int i = 0; i < 300; ++i) {
    const double s = stage_.street.length * rng.uniform(), angle = 340 * rng.uniform() - 170;
    const Ray ray{{s, scan_.drive.lane, stage_.street.road_height(s) + scan_.drive.height},
                  pulse_direction(scan_.drive, 1 + static_cast<int>(rng.below(2)), angle)};
    std::optional<PartHit> nearest;
    for (const Part& part : stage_.model.scene.parts)
      if (const auto hit = meet(ray, part, 0); hit && (!nearest || hit->t < nearest->t)) nearest = hit;
    const auto found = scene.cast(ray);
    ASSERT_EQ(found.has_value(), nearest.has_value());
    if (!found) continue;
    EXPECT_EQ(found->t, nearest->t);
    EXPECT_EQ(found->surface, nearest->surface);
  }
}

// Whether the way between two places passes through the middle of a car: its box, a quarter shorter and half as high.
bool blocked(const StreetObject& car, Vec3 from, Vec3 to) {
  const SinCos h = car.plan.heading;
  const auto local = [&](Vec3 p) {
    const double x = p.x - car.plan.x, y = p.y - car.plan.y;
    return Vec3{x * h.cos + y * h.sin, y * h.cos - x * h.sin, p.z - car.pose.base.z};
  };
  const Vec3 a = local(from), b = local(to);
  for (double share = 0; share <= 1; share += 0.01) {
    const Vec3 p = a + share * (b - a);
    if (std::abs(p.x) < 0.7 * car.plan.half_length && std::abs(p.y) < 0.9 * car.plan.half_width && p.z > 0.3 &&
        p.z < 0.6)
      return true;
  }
  return false;
}

TEST_F(SparseStreet, CarsThrowShadowsOnThePavement) {
  // Every place of the ground is seen by each head from one place of the drive, up to the turn of its plane.
  const double tangent = tan_deg(scan_.drive.turned_deg);
  std::map<std::pair<int, int>, int> ground;  // points per 10 cm
  const RecordLayout layout = coloured_layout(0.001);
  for (std::size_t at = 0; at < records_.size(); at += kStreetRecord) {
    if (truth_of(&records_[at]).true_class != static_cast<int>(StreetClass::ground)) continue;
    const Vec3 p = scene_to_street(place_of(&records_[at], layout));
    ++ground[{static_cast<int>(std::floor(p.x * 10)), static_cast<int>(std::floor(p.y * 10))}];
  }
  int shadows = 0;
  for (const StreetObject& car : stage_.objects) {
    if (car.artefact_class != ArtefactClass::car) continue;
    for (double along = -1.5; along <= 1.5; along += 0.3)
      for (double behind = 0.3; behind < 2; behind += 0.3) {
        const double side = car.plan.y > 0 ? 1 : -1;
        const double t = car.plan.y + side * (car.plan.half_width + behind), s = car.plan.x + along;
        bool dark = true;
        for (double corner_s : {-0.05, 0.05})
          for (double corner_t : {-0.05, 0.05})
            for (double turn : {-1.0, 1.0}) {
              const Vec3 place{s + corner_s, t + corner_t, stage_.street.ground_height(s, t)};
              const double from = place.x + turn * (place.y - scan_.drive.lane) * tangent;
              const Vec3 head{from, scan_.drive.lane, stage_.street.road_height(from) + scan_.drive.height};
              dark = dark && blocked(car, head, place);
            }
        if (!dark) continue;
        ++shadows;
        const std::pair pixel{static_cast<int>(std::floor(s * 10)), static_cast<int>(std::floor(t * 10))};
        EXPECT_EQ(ground[pixel], 0) << car.id << " " << along << " " << behind;
      }
  }
  EXPECT_GT(shadows, 300);
}

TEST(StreetFile, CloudAndTruthAgree) {
  const auto folder = std::filesystem::temp_directory_path() / ("ilot_street_test_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  ScanRequest request{"street", SceneValues(street_options()), 2, 60000, folder / "street.las"};
  request.values.set("scene.blocks=3");
  const ScanCounts counts = scan_street_scene(request);
  std::ifstream file(truth_path(request.output));
  const nlohmann::json truth = nlohmann::json::parse(file);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(truth["counts"]["points"], counts[0].second);
  EXPECT_EQ(truth["counts"]["gaps"], 2);
  EXPECT_EQ(truth["blocks"].size(), 6u);
  EXPECT_EQ(truth["objects"].size(), 44u);  // 7 cars, 3 lampposts, 20 pedestrians, 14 others: rounded
  EXPECT_GT(truth["stations"].size(), 15u);
  for (const auto& plane : truth["planes"])
    for (const auto& polygon : plane["polygons"])
      for (const auto& p : polygon["ring"])
        EXPECT_NEAR(plane["plane"][0].get<double>() * p[0].get<double>() +
                        plane["plane"][1].get<double>() * p[1].get<double>() +
                        plane["plane"][2].get<double>() * p[2].get<double>() + plane["plane"][3].get<double>(),
                    0, 1e-3);
}

}  // namespace
}  // namespace ilot::scan
