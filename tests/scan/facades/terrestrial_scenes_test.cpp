// SPDX-License-Identifier: Apache-2.0
// What the larger terrestrial scenes promise: sizes, elements and shapes of the truth, and points that obey it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "kernels/core/parallel.h"
#include "scan/facades/banded_wall.h"
#include "scan/facades/building.h"
#include "scan/facades/facade_haussmann.h"
#include "scan/facades/shapes.h"
#include "scan/scanners/scan_record.h"
#include "tests/support/scan_records.h"

namespace ilot::scan {
namespace {

using Plan = TerrestrialScan (*)(const SceneValues&, std::uint64_t);

TerrestrialScan plan_scene(Plan make, std::span<const SceneOption> options,
                           std::initializer_list<const char*> settings = {}) {
  SceneValues values(options);
  for (const char* setting : settings) values.set(setting);
  return make(values, 0);
}

std::vector<std::byte> scene_bytes(const TerrestrialScan& scan, int threads = 2) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_terrestrial(
        scan, [&](std::span<const std::byte> records) { all.insert(all.end(), records.begin(), records.end()); });
  });
  return all;
}

void for_each_point(const std::vector<std::byte>& bytes, double grid,
                    const std::function<void(Vec3, const RecordTruth&)>& visit) {
  const RecordLayout layout = coloured_layout(grid);
  for (std::size_t at = 0; at < bytes.size(); at += layout.record_length)
    visit(place_of(&bytes[at], layout), truth_of(&bytes[at]));
}

// Points at the default step, from a sparser scan: they go with the inverse square of the step.
double points_at_default(TerrestrialScan scan, std::uint64_t sparse) {
  const double step = scan.scene.stations[0].step_horizontal_deg;
  fit_points(scan, sparse);
  const double scaled = scan.scene.stations[0].step_horizontal_deg;
  return static_cast<double>(scene_bytes(scan).size() / 45) * (scaled / step) * (scaled / step);
}

TEST(TerrestrialScenes, HaveTheSizesOfTheDocuments) {
  EXPECT_NEAR(points_at_default(plan_scene(plan_facade_haussmann, facade_haussmann_options()), 300000), 19e6, 1.9e6);
  EXPECT_NEAR(points_at_default(plan_scene(plan_building, building_options()), 300000), 36325675, 3.6e6);
}

TEST(TerrestrialScenes, SameBytesForAnyNumberOfThreads) {
  for (TerrestrialScan scan : {plan_scene(plan_shapes, shapes_options(), {"scene.step=0.3"}),
                               plan_scene(plan_building, building_options(), {"scene.step=0.6"}),
                               plan_scene(plan_facade_haussmann, facade_haussmann_options(), {"scene.step=0.25"})}) {
    const std::vector<std::byte> one = scene_bytes(scan, 1);
    EXPECT_GT(one.size() / 45, 20000u);
    for (int threads : {2, 3}) EXPECT_TRUE(scene_bytes(scan, threads) == one) << threads;
  }
}

// Every labelled point lies on its plane within six standard deviations of the range, the mixing that noise hides and
// the angles' noise at grazing incidence; shapes as well.
TEST(TerrestrialScenes, PointsLieOnTheirTruePlanesAndShapes) {
  for (TerrestrialScan scan : {plan_scene(plan_shapes, shapes_options(), {"scene.step=0.2"}),
                               plan_scene(plan_building, building_options(), {"scene.step=0.4"}),
                               plan_scene(plan_facade_haussmann, facade_haussmann_options(), {"scene.step=0.15"})}) {
    std::map<std::uint32_t, Plane> planes;
    std::map<std::uint32_t, TrueShape> shapes;
    for (const TruePlane& p : scan.scene.planes) EXPECT_TRUE(planes.emplace(p.id, p.plane).second);
    for (const TrueShape& s : scan.scene.shapes) {
      EXPECT_TRUE(shapes.emplace(s.id, s).second);
      EXPECT_EQ(planes.count(s.id), 0u);
    }
    std::size_t on_planes = 0, on_shapes = 0;
    for_each_point(scene_bytes(scan), scan.grid, [&](Vec3 p, const RecordTruth& truth) {
      if (truth.true_plane == 0) return;
      double distance = 0;
      if (const auto plane = planes.find(truth.true_plane); plane != planes.end()) {
        distance = signed_distance(plane->second, p);
        ++on_planes;
      } else {
        const TrueShape& s = shapes.at(truth.true_plane);
        const Vec3 offset = p - s.point;
        const double along = dot(offset, s.axis), radial = norm(offset - along * s.axis);
        const SinCos half = sin_cos_deg(s.half_angle_deg);
        distance = s.kind == "sphere" ? norm(offset) - s.radius
                   : s.kind == "cone" ? radial * half.cos - along * half.sin
                                      : radial - s.radius;
        ++on_shapes;
      }
      ASSERT_LT(std::abs(distance), 0.02) << truth.true_plane;
    });
    EXPECT_GT(on_planes, 10000u);
    EXPECT_EQ(on_shapes > 0, !shapes.empty());
  }
}

TEST(TerrestrialScenes, ShapesOfEachKindStandAboveAndBelow500Points) {
  const TerrestrialScan scan = plan_scene(plan_shapes, shapes_options());
  std::map<std::uint32_t, std::size_t> points;
  for_each_point(scene_bytes(scan), scan.grid, [&](Vec3, const RecordTruth& truth) { ++points[truth.true_plane]; });
  std::map<std::string, std::set<bool>> sides;
  for (const TrueShape& s : scan.scene.shapes) sides[s.kind].insert(points[s.id] > 500);
  for (const TruePlane& p : scan.scene.planes) sides["plane"].insert(points[p.id] > 500);
  ASSERT_EQ(sides.size(), 4u);
  for (const auto& [kind, both] : sides) EXPECT_EQ(both.size(), 2u) << kind;
}

TEST(TerrestrialScenes, TheBuildingHasBulgesOfTwoToSixCentimetres) {
  const TerrestrialScan scan = plan_scene(plan_building, building_options(), {"scene.step=0.2", "scene.noise=0"});
  std::map<std::uint32_t, double> rise, highest;
  std::map<std::uint32_t, std::uint32_t> facade_of;
  std::map<std::uint32_t, Plane> facades;  // by facade, in the order of their walls
  for (const TrueElement& e : scan.scene.elements)
    if (e.kind == "bulge") {
      rise[e.id] = e.depth;
      facade_of[e.id] = e.facade;
    }
  std::uint32_t facade = 0;
  for (const TruePlane& p : scan.scene.planes)
    if (p.surface_class == "facade") facades[++facade] = p.plane;
  ASSERT_EQ(facades.size(), 4u);
  EXPECT_GE(rise.size(), 10u);
  for_each_point(scene_bytes(scan), scan.grid, [&](Vec3 p, const RecordTruth& truth) {
    if (truth.true_class != static_cast<std::uint8_t>(BuildingClass::bulge)) return;
    const double out = signed_distance(facades.at(facade_of.at(truth.true_element)), p);
    highest[truth.true_element] = std::max(highest[truth.true_element], out);
    EXPECT_GT(out, -0.003);
  });
  EXPECT_EQ(highest.size(), rise.size());  // each is seen
  for (const auto& [id, out] : highest) {
    EXPECT_GE(rise[id], 0.02 - 1e-9);
    EXPECT_LE(rise[id], 0.06 + 1e-9);
    EXPECT_NEAR(out, rise[id], 0.006) << id;
  }
}

TEST(TerrestrialScenes, RoundArchesHaveTheirArcsInTheTruth) {
  const TerrestrialScene scene = plan_scene(plan_facade_haussmann, facade_haussmann_options()).scene;
  int round = 0;
  for (const TrueElement& e : scene.elements) {
    if (e.arcs.empty()) continue;
    ++round;
    const TrueArc& arc = e.arcs[0];
    // The outline's points above the springing lie on the arc.
    std::size_t on_arc = 0;
    for (const Vec3& p : e.ring) on_arc += std::abs(norm(p - arc.centre) - arc.radius) < 1e-6;
    EXPECT_GE(on_arc, 5u) << e.kind;
  }
  EXPECT_EQ(round, 4 * 7);  // shops, mezzanine, fourth floor, dormers
}

TEST(TerrestrialScenes, IntervalsOfAWallLeaveItsOpeningsOut) {
  const std::vector<Opening> openings{{1, 3, 0, 2, 1}, {5, 6, 1, 2, 0}};
  const auto at = [&](double z) { return solid_intervals(0, 8, z, openings); };
  ASSERT_EQ(at(1.5).size(), 3u);
  EXPECT_DOUBLE_EQ(at(1.5)[1][0], 3);
  EXPECT_DOUBLE_EQ(at(1.5)[1][1], 5);
  ASSERT_EQ(at(2.6).size(), 2u);  // 0.6 above the springing of a circle of radius 1: half a width of 0.8
  EXPECT_NEAR(at(2.6)[0][1], 1.2, 1e-12);
  EXPECT_EQ(at(3.5).size(), 1u);
}

}  // namespace
}  // namespace ilot::scan
