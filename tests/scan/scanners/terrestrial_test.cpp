// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/terrestrial.h"
#include "tests/support/scan_records.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "kernels/core/parallel.h"
#include "scan/facades/building.h"
#include "scan/facades/facade_builder.h"
#include "scan/facades/facade_haussmann.h"
#include "scan/facades/facade_restoration.h"
#include "scan/facades/shapes.h"
#include "scan/facades/stones.h"
#include "scan/scanners/scan_record.h"
#include "tests/support/temporary_folder.h"

namespace ilot::scan {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;

// A scanned point as the tests need it.
struct Seen {
  Vec3 place;
  RecordTruth truth;
  PointFields fields;
};

std::vector<std::byte> bytes_of(const TerrestrialScan& scan, int threads = 2) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_terrestrial(
        scan, [&](std::span<const std::byte> records) { all.insert(all.end(), records.begin(), records.end()); });
  });
  return all;
}

std::vector<Seen> points_of(const TerrestrialScan& scan) {
  const std::vector<std::byte> bytes = bytes_of(scan);
  const RecordLayout layout = coloured_layout(scan.grid);
  std::vector<Seen> points;
  for (std::size_t at = 0; at < bytes.size(); at += layout.record_length)
    points.push_back({place_of(&bytes[at], layout), truth_of(&bytes[at]), decode_fields({&bytes[at], 36}, 7)});
  return points;
}

TerrestrialScan plan_terrestrial(TerrestrialScan (*make)(const SceneValues&, std::uint64_t),
                                 std::span<const SceneOption> options, std::initializer_list<const char*> settings = {},
                                 std::uint64_t seed = 0) {
  SceneValues values(options);
  for (const char* setting : settings) values.set(setting);
  return make(values, seed);
}

TerrestrialScan stones(std::initializer_list<const char*> settings = {}) {
  return plan_terrestrial(plan_stones, stones_options(), settings);
}

TerrestrialScan restoration(std::initializer_list<const char*> settings = {}) {
  return plan_terrestrial(plan_facade_restoration, facade_restoration_options(), settings);
}

void silence(BeamParams& beam) {
  beam = {0, 0, 0, 0, 0.3};
}

// A wall along x through the origin, seen from the side of negative y; x from -20 to 20, z from 0 to 12.
TerrestrialScan wall_scan(Vec3 eye, double step_deg) {
  TerrestrialScan scan;
  scan.scene.classes = {{1, "wall"}, {2, "sill"}};
  FacadeBuilder facade(scan.scene, {}, 1);
  facade.wall(-20, 20, 0, 12, 0, {}, {1, 0, Material::white_target});
  scan.scene.keep = {{-30, -5, -1}, {30, 5, 30}};
  scan.scene.stations = {station_towards(1, eye, bounds_of(scan.scene.model.parts), step_deg)};
  silence(scan.beam);
  return scan;
}

// Points per area as the angular steps predict them [Lorraine thesis, 3.3]: du dv with u along the wall and v up it.
double predicted_density(Vec3 eye, Vec3 p, double step_deg) {
  const double d = -eye.y, dx = p.x - eye.x, dz = p.z - eye.z, flat = std::sqrt(d * d + dx * dx);
  const double cos_theta = d / flat, cos_phi = flat / std::sqrt(flat * flat + dz * dz), step = step_deg * kRadians;
  const double du = d * step / (cos_theta * cos_theta), dv = d * step / (cos_phi * cos_phi * cos_theta);
  return 1 / (du * dv);
}

TEST(Terrestrial, DensityFallsWithRangeAndIncidenceAsC6Predicts) {
  for (Vec3 eye : {Vec3{-6, -8, 1.6}, Vec3{10, -16, 1.6}}) {
    const double step = 0.08;
    const int cells_x = 20, cells_z = 5;  // cells of 2 m, those nearest to the border left out
    std::vector<double> counted(static_cast<std::size_t>(cells_x * cells_z));
    for (const Seen& p : points_of(wall_scan(eye, step))) {
      const int i = static_cast<int>(std::floor((p.place.x + 20) / 2)), k = static_cast<int>(std::floor(p.place.z / 2));
      if (i >= 0 && i < cells_x && k >= 0 && k < cells_z) ++counted[static_cast<std::size_t>(k * cells_x + i)];
    }
    double least = 1e9, most = 0;
    for (int k = 0; k < cells_z; ++k)
      for (int i = 1; i + 1 < cells_x; ++i) {
        double expected = 0;  // by the midpoint rule
        for (int a = 0; a < 20; ++a)
          for (int b = 0; b < 20; ++b)
            expected +=
                0.01 * predicted_density(eye, {-20 + 2 * i + 0.1 * (a + 0.5), 0, 2 * k + 0.1 * (b + 0.5)}, step);
        if (expected < 1600) continue;  // forty rows: one more or less weighs 2.5 %
        const double ratio = counted[static_cast<std::size_t>(k * cells_x + i)] / expected;
        EXPECT_NEAR(ratio, 1, 0.05) << i << " " << k;
        least = std::min(least, expected);
        most = std::max(most, expected);
      }
    EXPECT_GT(most, 4 * least);  // the wall shows both near and far
  }
}

TEST(Terrestrial, RangeNoiseHasTheStandardDeviationAskedForAlongTheRay) {
  const Vec3 eye{3, -12, 1.6};
  TerrestrialScan exact = wall_scan(eye, 0.15), noisy = exact;
  noisy.beam.range_noise = 0.02;
  noisy.scene.keep = exact.scene.keep = {{-30, -5, -5}, {30, 5, 30}};
  const std::vector<Seen> a = points_of(exact), b = points_of(noisy);
  ASSERT_EQ(a.size(), b.size());
  double sum = 0, squares = 0, sideways = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 ray = (1 / norm(a[i].place - eye)) * (a[i].place - eye), shift = b[i].place - a[i].place;
    const double along = dot(shift, ray);
    sum += along;
    squares += along * along;
    sideways = std::max(sideways, norm(shift - along * ray));
  }
  const double n = static_cast<double>(a.size());
  ASSERT_GT(n, 30000);
  EXPECT_NEAR(sum / n, 0, 5 * 0.02 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.02, 5 * 0.02 / std::sqrt(2 * n));
  // Two roundings to the grid of 0.1 mm, and a direction known to that grid over 12 m.
  EXPECT_LT(sideways, 0.0002);
}

TEST(Terrestrial, AngleNoiseMovesPointsByTheAngleAskedFor) {
  const Vec3 eye{0, -20, 10};
  TerrestrialScan scan = wall_scan(eye, 0.15);
  scan.beam.angle_noise_deg = 0.02;
  // The beam points elsewhere than the encoders say: the range found there is laid along the nominal direction.
  double squares = 0, count = 0;
  for (const Seen& p : points_of(scan)) {
    const Vec3 way = p.place - eye;
    if (std::abs(way.x) < 10 || std::abs(way.x) > 12 || std::abs(way.z) > 1) continue;
    // range = d / cos(azimuth): an error e in azimuth changes it by range tan(azimuth) e.
    const double range = norm(way), tangent = std::abs(way.x) / way.y;
    const double true_range = 20 / (way.y / range);
    squares += std::pow((range - true_range) / (range * tangent * 0.02 * kRadians), 2);
    ++count;
  }
  ASSERT_GT(count, 300);
  EXPECT_NEAR(std::sqrt(squares / count), 1, 5 / std::sqrt(2 * count) + 0.02);
}

TEST(Terrestrial, RegistrationMovesAllPointsOfAStationAlike) {
  TerrestrialScan exact = plan_terrestrial(plan_shapes, shapes_options(), {"scene.step=0.5"}), moved = exact;
  moved.registration = 0.01;
  const std::vector<Seen> a = points_of(exact), b = points_of(moved);
  ASSERT_EQ(a.size(), b.size());
  std::map<int, Vec3> shifts;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 shift = b[i].place - a[i].place, first = shifts.emplace(a[i].fields.source_id, shift).first->second;
    EXPECT_LT(norm(shift - first), 4 * exact.grid);
    EXPECT_LT(norm(shift), 0.01 * 6 * 1.8);
  }
  ASSERT_EQ(shifts.size(), 3u);
  EXPECT_GT(norm(shifts[1] - shifts[2]), 0.001);
}

TEST(Terrestrial, IntensityFallsWithTheSquareOfTheRangeAndWithTheCosine) {
  const Vec3 eye{0, -12, 5};
  const std::vector<Seen> points = points_of(wall_scan(eye, 0.5));
  ASSERT_GT(points.size(), 1000u);
  const auto model = [&](Vec3 p) {
    const double range = norm(p - eye);
    return 12 / range / (range * range);
  };
  const double scale = points[0].fields.intensity / model(points[0].place);
  for (const Seen& p : points) EXPECT_NEAR(p.fields.intensity, scale * model(p.place), 2 + 0.003 * p.fields.intensity);
}

// Every point is the first opaque thing on its ray, by intersecting all parts without Embree.
TEST(Terrestrial, NoRayPassesThroughAWall) {
  for (TerrestrialScan scan :
       {restoration({"scene.step=0.4"}), stones({"scene.step=0.15"}),
        plan_terrestrial(plan_facade_haussmann, facade_haussmann_options(), {"scene.step=0.8", "scene.bays=3"}),
        plan_terrestrial(plan_building, building_options(), {"scene.step=1"}),
        plan_terrestrial(plan_shapes, shapes_options(), {"scene.step=0.8"})}) {
    silence(scan.beam);
    std::size_t checked = 0;
    for (const Seen& p : points_of(scan)) {
      const Vec3 eye = scan.scene.stations.at(p.fields.source_id - 1u).position;
      const double range = norm(p.place - eye);
      const Ray ray{eye, (1 / range) * (p.place - eye)};
      for (const Part& part : scan.scene.model.parts) {
        // The direction is known to the grid only: keep off the edges by asking a little to all sides.
        int blocked = 0;
        for (const Vec3 off_axis : {Vec3{1, 1, 0}, Vec3{-1, -1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
          const Vec3 way = ray.direction + (2e-4 / range) * off_axis;
          const auto hit = meet({eye, (1 / norm(way)) * way}, part, 0);
          if (!hit || hit->t > range - 0.002) break;
          blocked += transmission(scan.scene.model.surfaces[hit->surface].material).through == 0;
        }
        ASSERT_LT(blocked, 4) << p.place.x << " " << p.place.y << " " << p.place.z;
      }
      ++checked;
    }
    EXPECT_GT(checked, 2000u);
  }
}

TEST(Terrestrial, ASillThrowsItsShadowWhereGeometrySays) {
  const Vec3 eye{0, -10, 1.6};
  TerrestrialScan scan = wall_scan(eye, 0.02);
  FacadeBuilder facade(scan.scene, {}, 1);
  const double out = 0.09, top = 6, bottom = 5.9, half = 0.6;
  facade.block({-half, half, 0, out, bottom, top}, {2, 0, Material::white_target});
  scan.scene.stations = {station_towards(1, eye, {{-1.5, 0, 5}, {1.5, 0.1, 7}}, 0.02)};
  // A ray over the front upper edge meets the wall at this height.
  const double shadow_top = top + out * (top - eye.z) / (-eye.y - out);
  const double shadow_side = half + out * half / (-eye.y - out);
  const double step = 0.02 * kRadians * 12;  // of points on the wall, at most
  double lowest = 1e9;
  std::size_t in_shadow = 0, beside = 0;
  for (const Seen& p : points_of(scan)) {
    if (p.truth.true_class != 1) continue;
    const double x = std::abs(p.place.x), z = p.place.z;
    if (x < half - 0.01 && z > bottom && z < shadow_top - 2e-4) ++in_shadow;
    if (x < half - 0.01 && z > bottom) lowest = std::min(lowest, z);
    if (x > shadow_side + 0.001 && z > bottom && z < shadow_top) ++beside;
    // Beside the sill the shadow is that of its front vertical edge.
    const bool beside_the_shadow = x > half && z > bottom + 0.05 && z < top - 0.01;
    EXPECT_TRUE(!beside_the_shadow || x > shadow_side - 2e-4) << x;
  }
  EXPECT_EQ(in_shadow, 0u);
  EXPECT_LT(lowest, shadow_top + 1.2 * step);
  EXPECT_GT(beside, 500u);
}

TEST(Terrestrial, MixedPointsLieOnTheRayBetweenBothSurfaces) {
  // A band of the wall stands 5 cm out of it.
  const Vec3 eye{1, -10, 4};
  TerrestrialScan scan = wall_scan(eye, 0.02);
  FacadeBuilder facade(scan.scene, {}, 1);
  facade.block({-20, 20, 0, 0.05, 4, 6}, {2, 0, Material::white_target});
  scan.scene.stations = {station_towards(1, eye, {{-1, 0, 3.5}, {3, 0.1, 6.5}}, 0.02)};
  scan.beam.divergence_mrad = 0.3;
  scan.beam.diameter = 0.006;
  const StationParams& station = scan.scene.stations[0];
  const double reach = footprint_radius(scan.beam, 12);
  std::size_t mixed = 0;
  for (const Seen& p : points_of(scan)) {
    if (p.truth.true_class != kMixedClass) continue;
    ++mixed;
    EXPECT_EQ(p.truth.true_plane, 0u);
    EXPECT_LT(p.place.y, 0);  // between the wall at 0 and the band at -0.05
    EXPECT_GT(p.place.y, -0.05);
    const Vec3 way = p.place - eye, right{station.forward.y, -station.forward.x, 0};
    const double azimuth = std::atan2(dot(way, right), dot(way, station.forward)) / kRadians / 0.02;
    const double elevation = std::atan2(way.z, std::sqrt(way.x * way.x + way.y * way.y)) / kRadians / 0.02;
    EXPECT_NEAR(azimuth, std::round(azimuth), 0.05);
    EXPECT_NEAR(elevation, std::round(elevation), 0.05);
    // At an edge of the band: lower or upper, in front or where the ray over it meets the wall.
    const double above = 6 + 0.05 * (6 - eye.z) / 9.95;
    EXPECT_TRUE(std::abs(p.place.z - 4) < reach || (p.place.z > 6 - reach && p.place.z < above + reach));
  }
  EXPECT_GT(mixed, 500u);
}

TEST(Terrestrial, StonesHaveTheCountsOfTheDocument) {
  std::array<double, 5> counts{};
  for (const Seen& p : points_of(stones())) ++counts[p.truth.true_class];
  const std::array<double, 5> wanted{0, 38330, 2575, 30022, 3176};
  for (std::size_t c = 1; c < 5; ++c) EXPECT_NEAR(counts[c], wanted[c], 0.1 * wanted[c]) << c;
  EXPECT_GT(counts[0], 100);
  EXPECT_LT(counts[0], 1500);
}

TEST(Terrestrial, FacadeRestorationHasTheCountsOfTheDocument) {
  std::array<double, 5> counts{};
  for (const Seen& p : points_of(restoration())) ++counts[p.truth.true_class];
  const std::array<double, 5> wanted{0, 407765, 7524, 73684, 95750};
  for (std::size_t c = 1; c < 5; ++c) EXPECT_NEAR(counts[c], wanted[c], 0.1 * wanted[c]) << c;
  EXPECT_NEAR(counts[0] + counts[1] + counts[2] + counts[3] + counts[4], 584723, 0.02 * 584723);
}

TEST(Terrestrial, FacadeRestorationHasTheControlPointsOfTheDocument) {
  const TerrestrialScene scene = restoration().scene;
  std::map<std::string, int> groups;
  for (const TrueControlPoint& p : scene.control_points) ++groups[p.group];
  EXPECT_EQ(groups["window_top"], 30);
  EXPECT_EQ(groups["window_bottom"], 30);
  EXPECT_EQ(groups["sill_top"], 20);
  EXPECT_EQ(groups["sill_bottom"], 20);
}

TEST(Terrestrial, SameBytesForAnyNumberOfThreads) {
  for (TerrestrialScan scan : {stones(), restoration({"scene.step=0.15"})}) {
    const std::vector<std::byte> one = bytes_of(scan, 1);
    EXPECT_GT(one.size(), 1000000u);
    for (int threads : {2, 3}) EXPECT_TRUE(bytes_of(scan, threads) == one) << threads;
    scan.seed = 1;
    EXPECT_FALSE(bytes_of(scan, 1) == one);
  }
}

TEST(Terrestrial, GivesAboutThePointsAskedFor) {
  for (std::uint64_t wanted : {100000u, 400000u}) {
    TerrestrialScan scan = restoration();
    fit_points(scan, wanted);
    const double points = static_cast<double>(bytes_of(scan).size() / 45);
    EXPECT_NEAR(points, static_cast<double>(wanted), 0.015 * static_cast<double>(wanted));
  }
}

TEST(Terrestrial, CloudAndTruthAgree) {
  const TemporaryFolder folder;
  ScanRequest request{"facade-restoration", SceneValues(facade_restoration_options()), 3, 60000,
                      folder.path() / "house.laz"};
  const ScanCounts counts = scan_planned<plan_facade_restoration>(request);
  const auto reader = open_cloud(request.output);
  const std::uint64_t n = reader->info().points;
  EXPECT_EQ(counts[0].second, n);
  EXPECT_EQ(reader->info().crs.epsg, 2154);
  EXPECT_TRUE(reader->info().warnings.empty());
  const RecordLayout& layout = reader->info().layout;
  std::vector<std::byte> records(n * layout.record_length);
  std::vector<std::uint8_t> valid(n);
  ASSERT_EQ(reader->read(0, records, valid), n);

  std::ifstream file(truth_path(request.output));
  const nlohmann::json truth = nlohmann::json::parse(file);
  EXPECT_EQ(truth["counts"]["points"], n);
  std::map<std::uint32_t, std::array<double, 4>> planes;
  std::map<std::uint32_t, std::uint64_t> declared, counted;
  for (const auto& plane : truth["planes"]) {
    const auto id = plane["id"].get<std::uint32_t>();
    EXPECT_TRUE(planes.emplace(id, plane["plane"].get<std::array<double, 4>>()).second);
    declared[id] = plane["points"];
    counted[id] = 0;
    for (const auto& polygon : plane["polygons"])
      for (const auto& p : polygon["ring"])
        EXPECT_NEAR(planes[id][0] * p[0].get<double>() + planes[id][1] * p[1].get<double>() +
                        planes[id][2] * p[2].get<double>() + planes[id][3],
                    0, 2e-4);
  }
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::byte* record = &records[i * layout.record_length];
    const std::uint32_t id = truth_of(record).true_plane;
    if (id == 0) continue;
    ++counted[id];
    const Vec3 p = place_of(record, layout) + Vec3{layout.offset[0], layout.offset[1], layout.offset[2]};
    const auto& q = planes.at(id);
    // Six standard deviations of 2 mm, the mixing that the noise hides, and the angles at 25 m of grazing view.
    ASSERT_LT(std::abs(q[0] * p.x + q[1] * p.y + q[2] * p.z + q[3]), 0.02);
  }
  EXPECT_EQ(counted, declared);
  EXPECT_EQ(truth["openings"].size(), 19u);
  EXPECT_EQ(truth["stations"].size(), 1u);
}

TEST(Terrestrial, LeavesNothingWhenItCannotWrite) {
  const TemporaryFolder folder;
  ScanRequest request{"stones", SceneValues(stones_options()), 0, {}, folder.path() / "stones.xls"};
  EXPECT_THROW(scan_planned<plan_stones>(request), Error);
  std::filesystem::create_directories(folder.path() / "stones.truth.json.part");
  request.output = folder.path() / "stones.las";
  EXPECT_THROW(scan_planned<plan_stones>(request), Error);
  std::filesystem::remove(folder.path() / "stones.truth.json.part");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace ilot::scan
