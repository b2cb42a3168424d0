// SPDX-License-Identifier: Apache-2.0
// The scene roofs-wild: sound solids of every form, the same bytes for any number of threads, truth that the points
// bear out, footprints with the faults that were drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "kernels/core/parallel.h"
#include "scan/roofs/roofs_truth.h"
#include "scan/scanners/scan_record.h"
#include "scan/wild/roofs/wild_roofs_scan.h"
#include "tests/support/scan_records.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kRoofsRecord = 45;
constexpr std::uint64_t kFewPoints = 60000;

struct WildRoofsCase {
  SceneValues values{wild_roofs_options()};
  Draws draws;
  WildRoofsScan scan;

  WildRoofsCase(std::initializer_list<std::string> settings, std::uint64_t seed, std::string_view without = "")
      : values(with(settings, without)),
        draws(values, kWildRoofsGroups, seed),
        scan(plan_wild_roofs(draws, seed, kFewPoints)) {
    fit_wild_roofs(scan, kFewPoints);
  }
  static SceneValues with(std::initializer_list<std::string> settings, std::string_view without) {
    SceneValues values(wild_roofs_options());
    for (const std::string& setting : settings) values.set(setting);
    values.leave_out(without, families_of(kWildRoofsGroups));
    return values;
  }
  std::vector<std::byte> records(int threads) const {
    std::vector<std::byte> all;
    with_threads(threads, [&] {
      scan_wild_roofs(scan, [&](std::span<const std::byte> r) { all.insert(all.end(), r.begin(), r.end()); });
    });
    return all;
  }
};

TEST(RoofsWild, EachFormIsAClosedSolidInMostDraws) {
  for (const WildRoofForm& form : wild_roof_forms()) {
    int sound = 0;
    std::map<std::string_view, int> faults;
    for (std::uint64_t draw = 0; draw < 40; ++draw) {
      Rng rng(draw, 5);
      const WildRoof roof = form.draw(rng);
      const RoofSolid solid = build_solid(partition_roof(roof.wings), -50);
      const auto fault = fault_of(solid, 0.02, 0.04);
      if (fault)
        ++faults[*fault];
      else
        ++sound;
      for (const CurvedRoof& curve : roof.curved) ASSERT_LT(curve.wing, roof.wings.size());
      EXPECT_LE(roof.wings[0].planes.size() + 4, ConvexSolid::kMaxFaces);
    }
    EXPECT_GE(sound, 30) << form.name << ": " << (faults.empty() ? "" : std::string(faults.begin()->first));
  }
}

// The curved surface lies below its facets and never far from them.
TEST(RoofsWild, CurvesLieCloseBelowTheirFacets) {
  for (const WildRoofForm& form : wild_roof_forms()) {
    Rng rng(3, 5);
    const WildRoof roof = form.draw(rng);
    for (const CurvedRoof& curve : roof.curved) {
      const Wing& wing = roof.wings[curve.wing];
      for (double x = 0.02; x < 1; x += 0.04)
        for (double y = 0.02; y < 1; y += 0.04) {
          const double u = static_cast<double>(wing.rect.u0) + x * static_cast<double>(wing.rect.u1 - wing.rect.u0);
          const double v = static_cast<double>(wing.rect.v0) + y * static_cast<double>(wing.rect.v1 - wing.rect.v0);
          const auto inside = chord({{0.001 * u, 0.001 * v, 500}, {0, 0, -1}}, curve.surface);
          if (!inside) continue;
          const double below = 0.001 * height_mm(wing, u, v) - (500 - inside->enter);
          EXPECT_GT(below, -1e-6) << form.name;
          // Eight sides around a circle stand out of it by 8 % of its radius in the corners.
          const Vec3 on_curve{0.001 * u, 0.001 * v, 500 - inside->enter};
          EXPECT_LT(below * normal_at(curve.surface, on_curve).z, 0.085 * curve.surface.radius) << form.name;
        }
    }
  }
}

TEST(RoofsWild, SameBytesForAnyNumberOfThreads) {
  const WildRoofsCase c({}, 31);
  const std::vector<std::byte> one = c.records(1);
  EXPECT_NEAR(static_cast<double>(one.size() / kRoofsRecord), static_cast<double>(kFewPoints),
              0.15 * static_cast<double>(kFewPoints));
  for (const int threads : {2, 5}) EXPECT_TRUE(c.records(threads) == one) << threads;
  EXPECT_TRUE(WildRoofsCase({}, 31).records(2) == one);
}

TEST(RoofsWild, PointsLieOnTheirPlanes) {
  const WildRoofsCase c({"scene.roofs.noise=0.008", "scene.roofs.strip_shift=0", "scene.roofs.trees=40",
                         "scene.roofs.stray_points=0", "scene.roofs.ground=whole"},
                        7);
  std::vector<std::uint64_t> none(c.scan.wild.town.plane_count + kFirstWildPlane);
  const std::vector<TruePlane> planes = planes_of_town(c.scan.wild.town, none);
  std::set<std::uint32_t> curved;
  for (const WingSurface& wing : c.scan.wild.wings)
    if (wing.curve) curved.insert(wing.building + 1);
  const std::vector<std::byte> records = c.records(2);
  const RecordLayout layout = coloured_layout(0.001);
  std::map<int, int> of_class;
  for (std::size_t at = 0; at < records.size(); at += kRoofsRecord) {
    const RecordTruth truth = truth_of(&records[at]);
    ++of_class[truth.true_class];
    if (truth.true_plane == 0 || curved.contains(truth.true_element)) continue;
    const double d = signed_distance(planes[truth.true_plane].plane, place_of(&records[at], layout));
    ASSERT_LT(std::abs(d), 0.11) << planes[truth.true_plane].surface_class;
  }
  for (const RoofClass needed : {RoofClass::ground, RoofClass::roof, RoofClass::wall, RoofClass::vegetation})
    EXPECT_GT(of_class[static_cast<int>(needed)], 100) << static_cast<int>(needed);
}

TEST(RoofsWild, GroundCanBeMissing) {
  const WildRoofsCase c({"scene.roofs.ground=none", "scene.roofs.stray_points=0", "scene.roofs.glass=0"}, 12);
  const std::vector<std::byte> records = c.records(2);
  ASSERT_FALSE(records.empty());
  for (std::size_t at = 0; at < records.size(); at += kRoofsRecord) ASSERT_NE(truth_of(&records[at]).true_class, 1);
}

TEST(RoofsWild, FamiliesCanBeLeftOut) {
  const WildRoofsCase c(
      {}, 2, "spires,domes,barrels,tents,saw_teeth,glass,terraces,halls,trees,cars,solar,chimneys,equipment,parapets");
  const std::set<std::string_view> usual{"gable", "hip", "complex", "flat", "shed", "hut"};
  for (const std::string_view form : c.scan.wild.forms) EXPECT_TRUE(usual.contains(form)) << form;
  EXPECT_TRUE(c.scan.wild.trees.empty() && c.scan.wild.cars.empty() && c.scan.wild.extras.empty());
}

double doubled_plan_area(const std::vector<Vec3>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += (a.x - ring[0].x) * (b.y - ring[0].y) - (b.x - ring[0].x) * (a.y - ring[0].y);
  }
  return sum;
}

TEST(RoofsWild, FootprintsHaveTheFaultsThatWereDrawn) {
  WildRoofsCase exact({"scene.roofs.footprints_shift=0", "scene.roofs.footprints_error=0",
                       "scene.roofs.footprints_missing=0", "scene.roofs.footprints_merged=0"},
                      9);
  const std::size_t buildings = exact.scan.wild.town.buildings.size();
  const auto all = draw_footprints(exact.scan.wild, exact.draws);
  ASSERT_EQ(all.size(), buildings);
  for (const WildFootprint& f : all) EXPECT_GT(doubled_plan_area(f.rings[0]), 0);
  WildRoofsCase moved({"scene.roofs.footprints_shift=0.5", "scene.roofs.footprints_error=0",
                       "scene.roofs.footprints_missing=0", "scene.roofs.footprints_merged=1"},
                      9);
  std::size_t covered = 0;
  for (const WildFootprint& f : draw_footprints(moved.scan.wild, moved.draws)) {
    covered += f.buildings.size();
    EXPECT_GT(doubled_plan_area(f.rings[0]), 0);
    if (f.buildings.size() == 1) {
      const Vec3 by = f.rings[0][0] - all[f.id - 1].rings[0][0];
      EXPECT_NEAR(std::sqrt(by.x * by.x + by.y * by.y), 0.5, 1e-9);
    }
  }
  EXPECT_EQ(covered, buildings);
  WildRoofsCase fewer({"scene.roofs.footprints_missing=0.2"}, 9);
  EXPECT_LT(draw_footprints(fewer.scan.wild, fewer.draws).size(), buildings);
}

}  // namespace
}  // namespace ilot::scan
