// SPDX-License-Identifier: Apache-2.0
// The scene street-wild: the same bytes for any number of threads, truth that the points bear out, options that fix
// what is drawn, families that are left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "kernels/core/parallel.h"
#include "scan/scanners/scan_record.h"
#include "scan/wild/street/wild_pavements.h"
#include "scan/wild/street/wild_street_scan.h"
#include "tests/support/scan_records.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kWildRecord = 45;

struct WildTestScan {
  WildStreetScan scan;
  std::vector<std::byte> records;
};

WildStreetScan plan_wild(std::initializer_list<std::string> settings, std::uint64_t seed, std::string_view without = "",
                         std::uint64_t points = 20000) {
  SceneValues values(wild_street_options());
  for (const std::string& setting : settings) values.set(setting);
  values.leave_out(without, families_of(kWildStreetGroups));
  Draws draws(values, kWildStreetGroups, seed);
  WildStreetScan scan = plan_wild_street_scan(draws, seed, points);
  fit_wild_points(scan, points, true);
  return scan;
}

std::vector<std::byte> wild_records(const WildStreetScan& scan, int threads) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_wild_street(scan, [&](std::span<const std::byte> r) { all.insert(all.end(), r.begin(), r.end()); });
  });
  return all;
}

const std::array<std::string, 3> kPlatforms{"vehicle", "tripod", "air"};

TEST(StreetWild, SameBytesForAnyNumberOfThreads) {
  for (const std::string& platform : kPlatforms) {
    const WildStreetScan scan = plan_wild({"scene.street.platform=" + platform}, 11);
    const std::vector<std::byte> one = wild_records(scan, 1);
    EXPECT_GT(one.size() / kWildRecord, 12000u) << platform;
    EXPECT_TRUE(wild_records(scan, 3) == one) << platform;
    EXPECT_TRUE(wild_records(plan_wild({"scene.street.platform=" + platform}, 11), 2) == one) << platform;
  }
}

TEST(StreetWild, AboutAsManyPointsAsAskedFor) {
  for (const std::string& platform : kPlatforms) {
    const WildStreetScan scan = plan_wild({"scene.street.platform=" + platform}, 4, "", 40000);
    EXPECT_NEAR(static_cast<double>(wild_records(scan, 2).size() / kWildRecord), 40000, 0.08 * 40000) << platform;
  }
}

// Distance of a place from the true box of an object, 0 inside.
double distance_to_box(const WildObject& object, Vec3 p) {
  const Vec3 from = p - object.pose.base;
  const SinCos h = object.pose.heading, q = object.pose.pitch;
  const Vec3 flat{from.x * h.cos + from.y * h.sin, from.y * h.cos - from.x * h.sin, from.z};
  const Vec3 local{flat.x * q.cos + flat.z * q.sin, flat.y, flat.z * q.cos - flat.x * q.sin};
  const auto beyond = [](double v, double low, double high) { return std::max({0.0, low - v, v - high}); };
  return std::max({beyond(local.x, object.box.min.x, object.box.max.x),
                   beyond(local.y, object.box.min.y, object.box.max.y),
                   beyond(local.z, object.box.min.z, object.box.max.z)});
}

TEST(StreetWild, PointsLieOnWhatTheTruthSays) {
  for (const std::string& platform : kPlatforms) {
    const WildStreetScan scan =
        plan_wild({"scene.street.platform=" + platform, "scene.street.noise=0.002", "scene.street.air_noise=0.008",
                   "scene.street.pass_shift=0", "scene.street.wander=0", "scene.street.stray_points=0",
                   "scene.street.roughness=0.002", "scene.street.bow=0"},
                  21);
    const std::vector<std::byte> records = wild_records(scan, 2);
    const RecordLayout layout = coloured_layout(0.001);
    std::map<std::uint32_t, std::uint64_t> per_object;
    std::uint64_t on_planes = 0;
    // An echo from the edge of the footprint is written on its axis.
    const double off_axis =
        platform == "air" ? 0.00065 * scan.scanner.beam.divergence_mrad * scan.scanner.beam.range : 0;
    for (std::size_t at = 0; at < records.size(); at += kWildRecord) {
      const RecordTruth truth = truth_of(&records[at]);
      const Vec3 p = scan.street.to_street(place_of(&records[at], layout));
      ASSERT_GT(p.z, scan.street.ground_height(p.x, p.y) - 5);  // the sides of terraces end below the ground
      if (truth.true_plane > 0) {
        const TruePlane& plane = scan.model.street.planes[truth.true_plane - 1];
        ASSERT_LT(std::abs(signed_distance(plane.plane, p)), 0.06 + off_axis) << plane.surface_class;
        ++on_planes;
      }
      if (truth.true_element == 0) continue;
      const WildObject& object = scan.objects[truth.true_element - 1];
      ++per_object[object.id];
      if (!object.moves()) {
        ASSERT_LT(distance_to_box(object, p), 0.08 + off_axis) << object.kind->name;
      }
    }
    EXPECT_GT(on_planes, 5000u);
    EXPECT_GT(per_object.size(), 5u) << platform;
  }
}

TEST(StreetWild, GroundHeightIsWhereARayFromAboveMeetsTheGround) {
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    const WildStreetScan scan = plan_wild({}, seed, "trees");
    std::vector<Part> ground;
    for (const Part& part : scan.model.street.scene.parts)
      if (const auto* solid = std::get_if<Solid>(&part);
          solid && scan.model.street.scene.surfaces[solid->surfaces[0]].true_class ==
                       static_cast<std::uint8_t>(StreetClass::ground))
        ground.push_back(part);
    const PartScene scene(ground);
    Rng rng(seed);
    for (int i = 0; i < 2000; ++i) {
      const double s = between(rng, -5, scan.street.length + 5), t = between(rng, -30, 30);
      const auto hit = scene.cast({{s, t, 500}, {0, 0, -1}});
      if (!scan.street.patch_at(s, t)) {
        EXPECT_FALSE(hit) << s << " " << t;
        continue;
      }
      ASSERT_TRUE(hit) << s << " " << t;
      EXPECT_NEAR(500 - hit->t, scan.street.ground_height(s, t), 1e-5) << s << " " << t;
    }
  }
}

TEST(StreetWild, KerbsStandAboveTheRoadByTheirHeight) {
  const WildStreetScan scan = plan_wild({"scene.street.kerb=0.12", "scene.street.layout=crossing"}, 5);
  ASSERT_FALSE(scan.model.kerbs.empty());
  for (const Kerb& kerb : scan.model.kerbs)
    for (const Vec3& p : kerb.line) {
      const double inwards = p.y > 0 ? -0.001 : 0.001;
      EXPECT_NEAR(p.z - scan.street.ground_height(p.x, p.y + inwards), kerb.height, 1e-3);
      EXPECT_NEAR(std::abs(p.y), scan.street.half_road, 1e-9);
    }
}

TEST(StreetWild, PavementsEndAtTheWallsThatRaysMeet) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const WildStreetScan scan = plan_wild({}, seed, "balconies,shutters");
    std::vector<Part> walls;
    for (const Part& part : scan.model.street.scene.parts)
      if (const auto* panel = std::get_if<Panel>(&part);
          panel && scan.model.street.scene.surfaces[panel->surface].plane != 0)
        walls.push_back(part);
    const PartScene scene(walls);
    for (const TruePavement& piece : true_pavements(scan.street)) {
      EXPECT_EQ(piece.width, scan.street.pavement);
      if (!piece.to_facade) continue;
      const Vec3 middle = 0.5 * (piece.line.front() + piece.line.back());
      const double side = middle.y > 0 ? 1 : -1;
      // Above the windows of the ground floor there is wall.
      const auto hit = scene.cast({middle + Vec3{0.013, 0, 2.5}, {0, side, 0}});
      if (!hit || hit->t >= *piece.to_facade + 2) continue;  // through a window
      EXPECT_NEAR(hit->t, *piece.to_facade, 0.06);
    }
  }
}

TEST(StreetWild, FamiliesCanBeLeftOut) {
  const auto families = [](const WildStreetScan& scan) {
    std::set<std::string_view> all;
    for (const WildObject& object : scan.objects) all.insert(object.kind->family);
    return all;
  };
  std::set<std::string_view> seen;
  for (std::uint64_t seed = 0; seed < 6; ++seed) seen.merge(families(plan_wild({}, seed)));
  for (const ObjectKind& kind : object_kinds()) EXPECT_TRUE(seen.contains(kind.family)) << kind.family;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto left = families(plan_wild({}, seed, "trees,vehicles,people"));
    for (std::string_view family : {"trees", "vehicles", "people"}) EXPECT_FALSE(left.contains(family)) << family;
  }
}

TEST(StreetWild, NothingStaysAboveTheCut) {
  const WildStreetScan scan =
      plan_wild({"scene.street.platform=vehicle", "scene.street.cut=cut", "scene.street.cut_height=2"}, 8);
  const std::vector<std::byte> records = wild_records(scan, 2);
  const RecordLayout layout = coloured_layout(0.001);
  for (std::size_t at = 0; at < records.size(); at += kWildRecord) {
    const Vec3 p = scan.street.to_street(place_of(&records[at], layout));
    ASSERT_LT(p.z, scan.street.profile_height(p.x) + 2.001);
  }
}

// A walker who moves is met where it is at that moment; one that stands is met at its base.
TEST(StreetWild, MotionMovesAnObjectInTime) {
  WildMotion walks{{1.5, 0, 0}, 10, false, false, 7, 0};
  EXPECT_NEAR(offset_at(walks, 12, 1)->x, 3, 1e-12);
  EXPECT_NEAR(offset_at(walks, 10, 1)->x, 0, 1e-12);
  WildMotion parked{{0, 0, 0}, 0, true, false, 7, 0};
  int there = 0;
  for (std::uint16_t visit = 0; visit < 200; ++visit) {
    there += offset_at(parked, 0, visit).has_value();
    EXPECT_EQ(offset_at(parked, 0, visit).has_value(), offset_at(parked, 99, visit).has_value());
  }
  EXPECT_NEAR(there, 120, 30);
}

TEST(StreetObjectKinds, AtLeastSixtyAndEachStandsOnTheGround) {
  std::set<std::string_view> names;
  for (const ObjectKind& kind : object_kinds()) {
    names.insert(kind.name);
    for (std::uint64_t draw = 0; draw < 20; ++draw) {
      ObjectShape shape;
      Rng rng(draw);
      kind.make(shape, rng);
      ASSERT_FALSE(shape.solids.empty() && shape.leaves.empty()) << kind.name;
      double low = 1e9, high = -1e9;
      const auto take = [&](double a, double b) { low = std::min(low, a), high = std::max(high, b); };
      for (const Solid& solid : shape.solids) take(solid.bounds.min.z, solid.bounds.max.z);
      for (const Crown& leaf : shape.leaves) take(leaf.centre.z - leaf.radii.z, leaf.centre.z + leaf.radii.z);
      const bool hangs = kind.name == "awning" || kind.name == "hung_lamp";
      EXPECT_GT(low, -0.3) << kind.name;
      EXPECT_LT(low, hangs ? 8 : 0.25) << kind.name;
      EXPECT_GT(high, 0.2) << kind.name;
      EXPECT_LT(high, 19) << kind.name;
    }
  }
  EXPECT_GE(names.size(), 60u);
}

}  // namespace
}  // namespace ilot::scan
