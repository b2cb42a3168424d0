// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/cell_scan.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kDistrictRecord = 35;

DistrictScan plan_district(std::initializer_list<const char*> settings, std::uint64_t seed = 1,
                           std::optional<std::uint64_t> points = {}) {
  SceneValues values(district_options());
  for (const char* setting : settings) values.set(setting);
  return plan_district(values, seed, points);
}

std::vector<std::byte> records_of(const DistrictScan& scan, int threads) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_district(scan,
                  [&](const ScannedCell& item) { all.insert(all.end(), item.records.begin(), item.records.end()); });
  });
  return all;
}

Vec3 position(const std::byte* record) {
  const PointFields f = decode_fields({record, 30}, 6);
  return {f.x * 0.001, f.y * 0.001, f.z * 0.001};
}

TEST(DistrictScan, SameBytesForAnyNumberOfThreads) {
  const DistrictScan scan = plan_district({"scene.area_km2=0.2", "scene.density=2"});
  const std::vector<std::byte> one = records_of(scan, 1);
  EXPECT_GT(one.size() / kDistrictRecord, 300000u);
  for (int threads : {2, 3, 8}) EXPECT_TRUE(records_of(scan, threads) == one) << threads;
  EXPECT_FALSE(records_of(plan_district({"scene.area_km2=0.2", "scene.density=2"}, 2), 1) == one);
}

TEST(DistrictScan, GivesExactlyThePointsAskedFor) {
  for (std::uint64_t points : {1u, 1000u, 12345u, 300000u})
    for (const char* trees : {"scene.trees=0", "scene.trees=15", "scene.trees=60"})
      EXPECT_EQ(records_of(plan_district({trees}, 3, points), 2).size(), points * kDistrictRecord) << points << trees;
  // Around the size from which crowns are relied upon, whatever the town.
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    for (const char* trees : {"scene.trees=4", "scene.trees=15", "scene.trees=60"})
      EXPECT_EQ(records_of(plan_district({"scene.density=1", trees}, seed, 10100 + 3000 * seed), 2).size(),
                (10100 + 3000 * seed) * kDistrictRecord)
          << seed << trees;
}

TEST(DistrictScan, PulsesHaveTheDensityAskedFor) {
  for (double density : {1.0, 12.0, 40.0}) {
    DistrictScan scan = plan_district({"scene.area_km2=0.02", "scene.trees=0"});
    scan.flight.density = density;
    const double points = static_cast<double>(records_of(scan, 2).size() / kDistrictRecord);
    EXPECT_NEAR(points / 20000, density, 0.02 * density);
  }
}

TEST(DistrictScan, PointsLieOnTheirTruePlanes) {
  const DistrictScan scan = plan_district({"scene.area_km2=0.05", "scene.density=6"});
  const Plane ground = District(scan.district).ground().plane();
  double squares = 0;
  std::uint64_t counted = 0;
  std::set<std::uint32_t> seen;
  scan_district(scan, [&](const ScannedCell& item) {
    for (std::size_t at = 0; at < item.records.size(); at += kDistrictRecord) {
      const std::byte* record = &item.records[at];
      const std::uint32_t id = true_plane_of(record);
      const auto surface = static_cast<Surface>(load<std::uint8_t>(record + 30));
      ASSERT_EQ(id == 0, surface == Surface::vegetation);
      if (id == 0) continue;
      Plane plane = ground;
      if (id != kGroundPlane) {
        ASSERT_GE(id, item.first_plane);
        ASSERT_LT(id - item.first_plane, item.cell.plane_count);
        const auto& planes = item.cell.face_plane;
        const auto face =
            static_cast<std::size_t>(std::find(planes.begin(), planes.end(), id - item.first_plane) - planes.begin());
        plane = item.cell.faces[face].plane;
        ASSERT_EQ(item.cell.faces[face].surface, surface);
      }
      // Noise has a hard limit of six standard deviations along the ray; the grid adds less than a
      // millimetre.
      const double distance = signed_distance(plane, position(record));
      ASSERT_LT(std::abs(distance), 6 * scan.noise + 0.001);
      seen.insert(id);
      if (surface != Surface::ground) continue;
      squares += distance * distance;
      ++counted;
    }
  });
  // Ground is met within 20 degrees of the vertical: between cos(21) and 1 times the noise along the ray.
  const double sd = std::sqrt(squares / static_cast<double>(counted));
  EXPECT_GT(sd, 0.93 * scan.noise);
  EXPECT_LT(sd, 1.01 * scan.noise);
  EXPECT_GT(seen.size(), 100u);
}

TEST(DistrictScan, RangeNoiseHasTheStandardDeviationAskedForAlongTheRay) {
  DistrictScan scan = plan_district({"scene.area_km2=0.01", "scene.trees=0", "scene.jitter=0"});
  scan.noise = 0.05;
  DistrictScan quiet = scan;
  quiet.noise = 0;
  const std::vector<std::byte> noisy = records_of(scan, 1), exact = records_of(quiet, 1);
  ASSERT_EQ(noisy.size(), exact.size());
  const District district(scan.district);
  const FlightPlan flight(scan.flight, district.ground(), scan.district.seed);
  std::size_t at = 0;
  double sum = 0, squares = 0, sideways = 0;
  flight.for_each_pulse({0, 0, scan.district.side, scan.district.side}, [&](const Pulse& pulse) {
    const Vec3 shift = position(&noisy[at]) - position(&exact[at]);
    const double along = dot(shift, pulse.ray.direction);
    sum += along;
    squares += along * along;
    sideways = std::max(sideways, norm(shift - along * pulse.ray.direction));
    at += kDistrictRecord;
  });
  ASSERT_EQ(at, noisy.size());
  const double n = static_cast<double>(at / kDistrictRecord);
  EXPECT_NEAR(sum / n, 0, 5 * 0.05 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.05, 5 * 0.05 / std::sqrt(2 * n));
  EXPECT_LT(sideways, 0.0018);  // two roundings to the millimetre grid, at most sqrt(3) / 2 each
}

TEST(DistrictScan, PlaneIdsAreDenseAndRisingOverCells) {
  const DistrictScan scan = plan_district({"scene.area_km2=0.3", "scene.density=0.2"});
  std::uint32_t plane = kGroundPlane + 1, building = 1;
  scan_district(scan, [&](const ScannedCell& item) {
    EXPECT_EQ(item.first_plane, plane);
    EXPECT_EQ(item.first_building, building);
    plane += item.cell.plane_count;
    building += static_cast<std::uint32_t>(item.cell.houses.size());
  });
  EXPECT_GT(building, 300u);
}

TEST(DistrictScan, EchoesOfAPulseAreCountedInOrder) {
  std::uint64_t multiple_returns = 0;
  scan_district(plan_district({"scene.area_km2=0.05", "scene.trees=60"}), [&](const ScannedCell& item) {
    for (std::size_t at = 0; at < item.records.size();) {
      const PointFields first = decode_fields({&item.records[at], 30}, 6);
      ASSERT_EQ(first.return_number, 1);
      double height = 1e9;
      for (int echo = 1; echo <= first.return_count; ++echo, at += kDistrictRecord) {
        ASSERT_LT(at, item.records.size());
        const PointFields f = decode_fields({&item.records[at], 30}, 6);
        ASSERT_EQ(f.return_number, echo);
        ASSERT_EQ(f.return_count, first.return_count);
        ASSERT_LT(f.z * 0.001, height);
        height = f.z * 0.001;
      }
      multiple_returns += first.return_count > 1;
    }
  });
  EXPECT_GT(multiple_returns, 5000u);
}

std::string message_of(std::initializer_list<const char*> settings, std::optional<std::uint64_t> points = {}) {
  try {
    plan_district(settings, 0, points);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
  return "";
}

TEST(DistrictScan, RefusesWrongSettingsInASentence) {
  EXPECT_EQ(message_of({"scene.densty=3"}), "--set scene.densty: no such key; did you mean 'scene.density'?");
  EXPECT_EQ(message_of({"scene.density"}), "--set scene.density: write it as scene.key=value");
  EXPECT_EQ(message_of({"scene.density=many"}),
            "--set scene.density: \"many\" is not a number from 0.1 to 200 (pulses/m2)");
  for (const char* bad : {"scene.density=0", "scene.density=nan", "scene.density=1e999",
                          "scene.density=", "scene.noise=-1", "scene.density=12x"})
    EXPECT_NE(message_of({bad}), "") << bad;
  EXPECT_NE(message_of({"scene.density=3", "scene.area_km2=1"}, 1000), "");
}

}  // namespace
}  // namespace ilot::scan
