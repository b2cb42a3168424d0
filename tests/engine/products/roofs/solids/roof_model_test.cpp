// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/products/roofs/faces/roof_lines.h"
#include "engine/products/roofs/faces/roof_planes.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;
using test::valid;

std::size_t roof_faces(const Building& b) {
  return static_cast<std::size_t>(std::count_if(b.surfaces.begin(), b.surfaces.end(),
                                                [](const BuildingSurface& s) { return s.kind == SurfaceKind::roof; }));
}

double highest(const Building& b) {
  double z = -1e9;
  for (const Vec3& v : b.vertices) z = std::max(z, v.z);
  return z;
}

double gable(double, double y) {
  return 4 + std::min(y, 6 - y);
}

double hip(double x, double y) {
  return 4 + std::min({x, 12 - x, y, 6 - y});
}

// A high part and a low one, both flat.
double stepped(double x, double) {
  return x < 5 ? 8 : 4;
}

TEST(RoofModel, AFlatRoofIsABlock) {
  const RoofModel m = model_roof(roof_site(10, 6, [](double, double) { return 5.0; }), {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_TRUE(m.reason.empty());
  EXPECT_EQ(roof_faces(m.lod22), 1u);
  EXPECT_NEAR(highest(m.lod22), 5, 0.05);
  EXPECT_TRUE(valid(m.lod22));
  EXPECT_TRUE(valid(m.lod12));
}

TEST(RoofModel, AGableHasTwoFacesAndItsRidge) {
  const RoofModel m = model_roof(roof_site(12, 6, gable), {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_EQ(roof_faces(m.lod22), 2u);
  EXPECT_NEAR(highest(m.lod22), 7, 0.05);
  EXPECT_TRUE(valid(m.lod22));
  const auto on_face = std::count_if(m.face_of_point.begin(), m.face_of_point.end(), [](auto f) { return f > 0; });
  EXPECT_GE(on_face, static_cast<std::ptrdiff_t>(m.face_of_point.size() * 98 / 100));
}

TEST(RoofModel, AHipHasFourFaces) {
  const RoofModel m = model_roof(roof_site(12, 6, hip), {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_EQ(roof_faces(m.lod22), 4u);
  EXPECT_NEAR(highest(m.lod22), 7, 0.1);
  EXPECT_TRUE(valid(m.lod22));
}

TEST(RoofModel, AStepBecomesAWall) {
  const RoofModel m = model_roof(roof_site(12, 6, stepped), {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_EQ(roof_faces(m.lod22), 2u);
  EXPECT_TRUE(valid(m.lod22));
  // Where the wall stands: vertices inside the outline.
  for (const Vec3& v : m.lod22.vertices) {
    const double x = v.x - 85000;
    if (x > 0.01 && x < 11.99) {
      EXPECT_NEAR(x, 5, 0.25);
    }
  }
}

TEST(RoofModel, WithoutSuperstructuresTheMainRoofStays) {
  const auto dormer = [](double x, double y) { return x > 4 && x < 6 && y > 0.5 && y < 2 ? 6.5 : gable(x, y); };
  const RoofSite site = roof_site(12, 6, dormer);
  EXPECT_EQ(roof_faces(model_roof(site, {}, 1).lod22), 3u);
  RoofModelParams params;
  params.superstructures = false;
  const RoofModel m = model_roof(site, params, 1);
  EXPECT_EQ(m.status, RoofStatus::lod22);
  EXPECT_EQ(roof_faces(m.lod22), 2u);
}

TEST(RoofModel, FeetAreConvertedAtTheBoundary) {
  const RoofModel m = model_roof(roof_site(12, 6, gable), {}, 0.3048);
  EXPECT_NEAR(highest(m.lod22), 7 / 0.3048, 0.2);
}

TEST(RoofModel, FacesThatTheCheckRefusesFallBackToTheBlock) {
  const RoofSite site = roof_site(12, 6, gable);
  const RoofModel m =
      model_roof(site, {}, 1, [](const Building& b) { return std::string(b.lod == "2.2" ? "too steep" : ""); });
  EXPECT_EQ(m.status, RoofStatus::lod12);
  EXPECT_EQ(m.reason, "too steep");
  EXPECT_TRUE(m.lod22.surfaces.empty());
  const RoofModel none = model_roof(site, {}, 1, [](const Building&) { return std::string("leaks"); });
  EXPECT_EQ(none.status, RoofStatus::footprint_only);
  EXPECT_TRUE(none.lod12.surfaces.empty());
}

TEST(RoofModel, PointsOnALineGiveABlock) {
  RoofSite site = roof_site(12, 6, gable);
  site.points.clear();
  for (int i = 0; i < 300; ++i) site.points.push_back({0.04 * i, 3, 6});
  const RoofModel m = model_roof(site, {}, 1);
  EXPECT_EQ(m.status, RoofStatus::lod12);
  EXPECT_FALSE(m.reason.empty());
  EXPECT_TRUE(valid(m.lod12));
}

TEST(RoofModel, TooLittleToWorkOnSaysWhy) {
  RoofSite site = roof_site(12, 6, gable);
  site.points.resize(2);
  EXPECT_EQ(model_roof(site, {}, 1).status, RoofStatus::footprint_only);
  EXPECT_FALSE(model_roof(site, {}, 1).reason.empty());
  site = roof_site(12, 6, gable);
  site.outline[0] = {{0, 0}, {1000, 0}, {2000, 0}};
  EXPECT_EQ(model_roof(site, {}, 1).reason, "the outline has no area");
  site = roof_site(12, 6, gable);
  site.points.resize(20);
  EXPECT_NE(model_roof(site, {}, 1).status, RoofStatus::footprint_only);
}

// The vertices of the highest face, as a box in plan.
struct Extent {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
};

Extent extent_of_top(const RoofModel& m, Vec3 anchor) {
  Extent e;
  double top = -1e9;
  for (const BuildingSurface& s : m.lod22.surfaces) {
    if (s.kind != SurfaceKind::roof) continue;
    double z = 0;
    Extent here;
    for (const std::uint32_t v : s.rings[0]) {
      const Vec3 p = m.lod22.vertices[v] - anchor;
      z += p.z / static_cast<double>(s.rings[0].size());
      here = {std::min(here.x0, p.x), std::min(here.y0, p.y), std::max(here.x1, p.x), std::max(here.y1, p.y)};
    }
    if (z > top) e = here;
    top = std::max(top, z);
  }
  return e;
}

TEST(RoofModel, TheShadowOfAHighRoofIsTheLowOnes) {
  RoofSite site = roof_site(12, 8, stepped);
  std::erase_if(site.points, [](Vec3 p) { return p.x > 5 && p.x < 5.8; });
  const RoofModel m = model_roof(site, {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_NEAR(extent_of_top(m, site.anchor).x1, 5, 0.06);
}

TEST(RoofModel, ASmallBoxOnASteepRoofIsSeen) {
  const auto dormer = [](double x, double y) { return x > 5 && x < 6.5 && y > 1 && y < 1.6 ? 8.0 : 4 + 2.5 * y; };
  const RoofSite site = roof_site(12, 2.4, dormer, 12);
  const RoofModel m = model_roof(site, {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_EQ(roof_faces(m.lod22), 2u);
  EXPECT_TRUE(valid(m.lod22));
  RoofModelParams plain;
  plain.superstructures = false;
  EXPECT_EQ(roof_faces(model_roof(site, plain, 1).lod22), 1u);
}

TEST(RoofModel, ASteepTipMayBeWithoutPoints) {
  const auto steep = [](double x, double y) { return 4 + 1.3 * std::min({x, 9 - x, y, 6 - y}); };
  RoofSite site = roof_site(9, 6, steep);
  std::erase_if(site.points, [](Vec3 p) { return p.x < 4 && p.x > 2.4 && std::abs(p.y - 3) < p.x - 1.8; });
  const RoofModel m = model_roof(site, {}, 1);
  ASSERT_EQ(m.status, RoofStatus::lod22);
  EXPECT_EQ(roof_faces(m.lod22), 4u);
}

TEST(RoofModel, ARefusedRoofLosesItsSmallFacesFirst) {
  const auto boxes = [](double x, double y) { return y > 2 && y < 4 && x > 2 && x < 3.5 ? 7.0 : gable(x, y); };
  const RoofSite site = roof_site(12, 6, boxes);
  const std::size_t all = roof_faces(model_roof(site, {}, 1).lod22);
  ASSERT_GT(all, 2u);
  const RoofModel m = model_roof(site, {}, 1, [&](const Building& b) {
    return b.lod == "2.2" && roof_faces(b) > 2 ? std::string("too many faces") : std::string();
  });
  EXPECT_EQ(m.status, RoofStatus::lod22);
  EXPECT_TRUE(m.reason.empty());
  EXPECT_EQ(roof_faces(m.lod22), 2u);
}

// A perimeter block around a courtyard, 220 x 160 m, of 200 narrow houses whose ridges run along the street and whose
// heights differ: 400 faces of some 24 m2. The corners are flat.
constexpr double kBlockWidth = 220, kBlockDepth = 160, kWing = 14;

double perimeter_block(double x, double y) {
  const double south = y, north = kBlockDepth - y, west = x, east = kBlockWidth - x;
  const bool along_x = std::min(south, north) < kWing, along_y = std::min(west, east) < kWing;
  if (along_x && along_y) return 11;
  const double across = along_x ? std::min(south, north) : std::min(west, east);
  const auto house = static_cast<int>((along_x ? x : y) / 3.3);
  return 12 + 1.7 * (house % 5) + 0.6 * std::min(across, kWing - across);
}

TEST(RoofModel, APerimeterBlockOf400FacesIsOneValidSolid) {
  RoofSite site = roof_site(kBlockWidth, kBlockDepth, perimeter_block, 8);
  const auto in = [](double low, double v, double high) { return v > low && v < high; };
  std::erase_if(site.points, [&](const Vec3& p) {
    return in(kWing, p.x, kBlockWidth - kWing) && in(kWing, p.y, kBlockDepth - kWing);
  });
  const auto block = [](Vec3 p) {  // points come along a curve that fills space
    return std::pair(static_cast<int>(p.y / 7), (static_cast<int>(p.y / 7) % 2 == 0 ? 1 : -1) * static_cast<int>(p.x));
  };
  std::stable_sort(site.points.begin(), site.points.end(),
                   [&](const Vec3& a, const Vec3& b) { return block(a) < block(b); });
  const auto mm = [](double v) { return static_cast<std::int32_t>(v * 1000); };
  site.outline.push_back({{mm(kWing), mm(kWing)},
                          {mm(kWing), mm(kBlockDepth - kWing)},
                          {mm(kBlockWidth - kWing), mm(kBlockDepth - kWing)},
                          {mm(kBlockWidth - kWing), mm(kWing)}});
  const RoofModel model = model_roof(site, {}, 1, [](const Building& b) {
    const Faults faults = validate_building(b, {85000, 446000, 0}, 0.0001, {});
    return faults.empty() ? std::string() : std::to_string(faults[0].code);
  });
  ASSERT_EQ(model.status, RoofStatus::lod22) << model.reason;
  EXPECT_GE(roof_faces(model.lod22), 380u);
  EXPECT_LE(roof_faces(model.lod22), 440u);
  std::size_t lying = 0;
  for (const std::uint32_t face : model.face_of_point) lying += face != 0;
  EXPECT_GE(lying, site.points.size() * 95 / 100);
}

TEST(RoofPlanes, WallsAreNotRoofs) {
  RoofSite site = roof_site(12, 6, gable);
  Rng rng(2);
  for (int i = 0; i < 300; ++i) site.points.push_back({12 * rng.uniform(), 0.02 * rng.uniform(), 4 * rng.uniform()});
  const RoofPlanes planes = find_roof_planes(site, {});
  EXPECT_EQ(planes.planes.size(), 2u);
  EXPECT_GE(std::count(planes.on_wall.begin(), planes.on_wall.end(), 1), 200);
}

TEST(RoofLines, TheRidgeLiesWhereThePlanesMeet) {
  const RoofSite site = roof_site(12, 6, gable);
  const std::vector<FlatEdge> lines = roof_lines(site, find_roof_planes(site, {}));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].a.y, 3, 0.05);
  EXPECT_NEAR(lines[0].b.y, 3, 0.05);
  EXPECT_LT(std::min(lines[0].a.x, lines[0].b.x), 0);
  EXPECT_GT(std::max(lines[0].a.x, lines[0].b.x), 12);
}

}  // namespace
}  // namespace ilot
