// SPDX-License-Identifier: Apache-2.0
// Merges of faces by hand, as model_roof makes them.
#include "engine/products/roofs/solids/face_joining.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;
using test::valid;

std::size_t roof_faces(const RoofModel& m) {
  std::set<std::uint32_t> faces;
  for (const BuildingSurface& s : m.lod22.surfaces)
    if (s.kind == SurfaceKind::roof) faces.insert(s.plane_id);
  return faces.size();
}

double height_at(const RoofModel& m, double x, double y) {
  return m.map.planes[face_above(m.map, {x, y}) - 1].at(x, y);
}

RoofModel merged(RoofSite site, std::vector<FaceMerge> merges) {
  site.merges = std::move(merges);
  return model_roof(site, {}, 1);
}

// Three level parts: two with a step of 25 cm between them, and a high one.
double three_parts(double x, double) {
  return x < 4 ? 5 : x < 8 ? 5.25 : 9;
}

TEST(FaceJoining, NearPlanesBecomeOneThroughThePointsOfBoth) {
  const auto creased = [](double x, double) { return 4 + 0.53 * x + 0.13 * std::max(x - 4, 0.0); };
  RoofSite site = roof_site(8, 6, creased);
  ASSERT_EQ(roof_faces(model_roof(site, {}, 1)), 2u);
  site.merges = {{{2, 3}, {6, 3}}};
  const RoofModel m = model_roof(site, {}, 1);
  ASSERT_EQ(m.merges.size(), 1u);
  EXPECT_EQ(m.merges[0].outcome, EditOutcome::made) << m.merges[0].reason;
  EXPECT_EQ(roof_faces(m), 1u);
  EXPECT_TRUE(valid(m.lod22));
  EXPECT_NEAR(height_at(m, 4, 3), creased(4, 3) + 0.13, 0.03) << "above the crease";
}

TEST(FaceJoining, OtherwiseThePlaneOfTheFirstPlaceStays) {
  // A dormer that is none: a tree over the roof.
  const auto gable = [](double, double y) { return 4 + std::min(y, 6 - y); };
  const auto tree = [&](double x, double y) { return x > 4 && x < 6 && y > 0.5 && y < 2 ? 6.5 : gable(x, y); };
  const RoofSite site = roof_site(12, 6, tree);
  const RoofModel before = model_roof(site, {}, 1);
  ASSERT_EQ(roof_faces(before), 3u);
  const RoofModel m = merged(site, {{{2, 1}, {5, 1.2}}});
  EXPECT_EQ(m.merges[0].outcome, EditOutcome::made) << m.merges[0].reason;
  EXPECT_EQ(roof_faces(m), 2u);
  EXPECT_TRUE(valid(m.lod22));
  EXPECT_NEAR(height_at(m, 5, 1.2), gable(5, 1.2), 0.05);
  for (std::size_t i = 0; i < site.points.size(); ++i)
    if (std::abs(site.points[i].z - gable(site.points[i].x, site.points[i].y)) > 0.3) {
      ASSERT_EQ(m.face_of_point[i], 0u) << "points of the tree are on no face";
    }
}

TEST(FaceJoining, MergesFollowEachOther) {
  const auto steps = [](double x, double) { return x < 4 ? 5.0 : x < 8 ? 6.0 : 7.0; };
  const RoofSite site = roof_site(12, 6, steps);
  const RoofModel m = merged(site, {{{2, 3}, {6, 3}}, {{6, 3}, {10, 3}}, {{2, 3}, {10, 3}}});
  ASSERT_EQ(m.merges.size(), 3u);
  EXPECT_EQ(m.merges[0].outcome, EditOutcome::made) << m.merges[0].reason;
  EXPECT_EQ(m.merges[1].outcome, EditOutcome::made) << m.merges[1].reason;
  EXPECT_EQ(m.merges[2].outcome, EditOutcome::repeated);
  EXPECT_EQ(roof_faces(m), 1u);
  EXPECT_NEAR(height_at(m, 10, 3), 5, 0.02) << "the plane of the first place";
  EXPECT_TRUE(valid(m.lod22));
}

TEST(FaceJoining, WhatCannotBeMergedLeavesTheModelAsItWas) {
  const RoofSite site = roof_site(12, 6, three_parts);
  const RoofModel before = model_roof(site, {}, 1);
  const auto refused = [&](FaceMerge merge) {
    const RoofModel m = merged(site, {merge});
    EXPECT_EQ(m.merges[0].outcome, EditOutcome::without_partner);
    EXPECT_EQ(m.face_of_point, before.face_of_point);
    EXPECT_EQ(m.lod22.surfaces.size(), before.lod22.surfaces.size());
    return m.merges[0].reason;
  };
  EXPECT_EQ(refused({{2, 3}, {10, 3}}), "the faces of this edit do not touch, or a third one lies between them");
  EXPECT_EQ(refused({{2, 3}, {20, 3}}), "a place of this edit is on no face of the roof");
  RoofSite few = site;
  few.points.resize(2);
  few.merges = {{{2, 3}, {6, 3}}};
  EXPECT_EQ(model_roof(few, {}, 1).merges[0].reason, "the building has no faces of a roof");
}

TEST(FaceJoining, WithoutMergesNothingChanges) {
  const RoofSite site = roof_site(12, 6, three_parts);
  const RoofModel a = model_roof(site, {}, 1), b = merged(site, {{{2, 3}, {3, 3}}});
  EXPECT_EQ(b.merges[0].outcome, EditOutcome::repeated);
  EXPECT_EQ(a.face_of_point, b.face_of_point);
  ASSERT_EQ(a.lod22.vertices.size(), b.lod22.vertices.size());
  for (std::size_t i = 0; i < a.lod22.vertices.size(); ++i)
    EXPECT_EQ(norm(a.lod22.vertices[i] - b.lod22.vertices[i]), 0);
}

}  // namespace
}  // namespace ilot
