// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_flight.h"
#include "tests/support/scan_records.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/scan_record.h"
#include "scan/streets/street_garden.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kFlightRecord = 45;

StreetFlight plan_flight(std::initializer_list<const char*> settings, std::uint64_t seed = 0) {
  SceneValues values(street_flight_options());
  for (const char* setting : settings) values.set(setting);
  return plan_street_flight(values, seed);
}

std::vector<std::byte> records_of(const StreetFlight& flight, const StreetStage& stage, int threads) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_street_flight(flight, stage, [&](std::span<const std::byte> records) {
      all.insert(all.end(), records.begin(), records.end());
    });
  });
  return all;
}

TEST(StreetFlight, SameBytesForAnyNumberOfThreads) {
  const StreetFlight flight = plan_flight({"scene.blocks=2", "scene.density=5"});
  const StreetStage stage = set_stage(flight);
  const std::vector<std::byte> one = records_of(flight, stage, 1);
  EXPECT_GT(one.size() / kFlightRecord, 20000u);
  for (const int threads : {2, 3}) EXPECT_TRUE(records_of(flight, stage, threads) == one) << threads;
}

TEST(StreetFlight, AboutAsManyPointsAsAskedFor) {
  StreetFlight flight = plan_flight({"scene.blocks=3"});
  const StreetStage stage = set_stage(flight);
  for (const std::uint64_t points : {50000u, 200000u}) {
    fit_points(flight, stage, points);
    const auto n = static_cast<double>(records_of(flight, stage, 2).size() / kFlightRecord);
    EXPECT_NEAR(n, static_cast<double>(points), 0.1 * static_cast<double>(points));
  }
}

// Truth and points agree: planes, boxes of objects, the classes' names; the road is seen as densely as asked for.
TEST(StreetFlight, PointsLieWhereTheTruthSays) {
  const StreetFlight flight = plan_flight({"scene.blocks=6", "scene.density=10", "scene.mirrored=0"});
  const StreetStage stage = set_stage(flight);
  const std::vector<std::byte> records = records_of(flight, stage, 2);
  const RecordLayout layout = coloured_layout(0.001);
  std::map<int, int> of_class;
  int on_road = 0, second = 0;
  for (std::size_t at = 0; at < records.size(); at += kFlightRecord) {
    const RecordTruth t = truth_of(&records[at]);
    const Vec3 p = scene_to_street(place_of(&records[at], layout));
    ++of_class[t.true_class];
    if (t.true_class == static_cast<int>(StreetClass::ground)) {
      EXPECT_LE(std::abs(p.y), kGardenTo + 0.2);
    }
    on_road += p.x > 20 && p.x < 100 && std::abs(p.y) < 4;
    second += decode_fields({&records[at], 36}, 7).return_number > 1;
    if (t.true_plane > 0) {
      ASSERT_LT(std::abs(signed_distance(stage.model.planes[t.true_plane - 1].plane, p)), 6 * 0.02 + 0.002);
    }
    if (t.true_element == 0) continue;
    const StreetObject& o = stage.objects[t.true_element - 1];
    ASSERT_TRUE(closer(o.plan, PlanBox{p.x, p.y, {}, 0, 0}, 6 * 0.02 + 0.002)) << o.variant;
    EXPECT_EQ(t.true_class, static_cast<int>(class_of(o.artefact_class)));
  }
  EXPECT_EQ(of_class.size(), 8u);
  EXPECT_GT(second, 100) << "crowns let pulses through";
  EXPECT_NEAR(on_road, 80 * 8 * 10, 0.1 * 80 * 8 * 10);
}

// Dark paint takes points from some cars and none from others.
TEST(StreetFlight, SomeCarsAreDark) {
  std::map<std::uint32_t, int> bright, dark;
  for (auto* points : {&bright, &dark}) {
    const StreetFlight flight =
        plan_flight({"scene.blocks=6", points == &dark ? "scene.mirrored=0.9" : "scene.mirrored=0"});
    const StreetStage stage = set_stage(flight);
    const std::vector<std::byte> records = records_of(flight, stage, 2);
    for (std::size_t at = 0; at < records.size(); at += kFlightRecord)
      if (const RecordTruth t = truth_of(&records[at]); t.true_class == static_cast<int>(StreetClass::car))
        ++(*points)[t.true_element];
  }
  int same = 0, fewer = 0;
  for (const auto& [car, points] : bright) (dark[car] == points ? same : fewer) += 1;
  EXPECT_GT(same, fewer);
  EXPECT_GE(fewer, 1);
}

}  // namespace
}  // namespace ilot::scan
