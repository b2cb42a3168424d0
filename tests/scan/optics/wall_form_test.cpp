// SPDX-License-Identifier: Apache-2.0
// Walls that bow, stones with joints, and heads of several arcs.
#include "scan/optics/wall_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan/optics/arch.h"
#include "scan/optics/exact_math.h"
#include "scan/optics/part.h"

namespace ilot::scan {
namespace {

Sheet upright_sheet(const WallForm& form, const WallRelief& relief) {
  Panel panel{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {{0, 0}, {10, 0}, {10, 8}, {0, 8}}, {}, 1};
  return {panel, 0, 0, form, relief, 2};
}

TEST(WallForm, RaysMeetABowedWallAtItsForm) {
  const WallForm form{10, 8, 0.02, 0.03, -0.01};
  const Part wall = upright_sheet(form, {});
  for (double x : {1.0, 5.0, 9.0})
    for (double z : {0.5, 4.0, 7.5}) {
      const Vec3 from{x - 3, -9, z - 1}, aim = Vec3{x, 0, z} - from;
      const Ray ray{from, (1 / norm(aim)) * aim};
      const auto hit = meet(ray, wall, 0);
      ASSERT_TRUE(hit);
      const Vec3 p = point_at(ray, hit->t);
      EXPECT_NEAR(-p.y, form.at(p.x, p.z), 1e-6);  // `out` is towards negative y
      EXPECT_EQ(hit->surface, 1u);
    }
}

TEST(WallForm, ThePlaneOfAFormLeavesNoTilt) {
  const WallForm lean{10, 8, 0.024, 0, 0};
  const FormPlane plane = plane_of_form(lean, 0, 10, 0, 8);
  EXPECT_NEAR(plane.up, 0.003, 1e-12);
  EXPECT_NEAR(plane.along, 0, 1e-12);
  EXPECT_NEAR(plane.base, 0, 1e-12);
  const WallForm bow{10, 8, 0, 0.03, 0};
  EXPECT_NEAR(plane_of_form(bow, 0, 10, 0, 8).base, 0.02, 0.002);  // a parabola has two thirds of its height as mean
}

TEST(WallForm, JointsLieBehindStones) {
  WallRelief relief;
  relief.stone_width = 0.5;
  relief.stone_height = 0.3;
  relief.joint = 0.02;
  relief.joint_depth = 0.015;
  const Part wall = upright_sheet({}, relief);
  const auto look = [&](double x, double z) { return *meet({{x, -5, z}, {0, 1, 0}}, wall, 0); };
  EXPECT_NEAR(look(0.3, 0.2).t, 5, 1e-9);
  EXPECT_EQ(look(0.3, 0.2).surface, 1u);
  EXPECT_NEAR(look(0.3, 0.01).t, 5.015, 1e-9);  // the joint below the first course
  EXPECT_EQ(look(0.3, 0.01).surface, 2u);
  EXPECT_NEAR(look(0.01, 0.2).t, 5.015, 1e-9);
  EXPECT_NEAR(look(0.01, 0.2 + 0.32).t, 5, 1e-9);  // the next course is shifted by half a stone
  // A flat ray does not reach the ground of a narrow joint.
  const Vec3 flat{0.98, 0.198997487421, 0};
  const auto grazed = meet({Vec3{0.01, 0, 0.2} - 5.0 * flat, flat}, wall, 0);
  ASSERT_TRUE(grazed);
  EXPECT_LT(point_at({Vec3{0.01, 0, 0.2} - 5.0 * flat, flat}, grazed->t).y, 0.012);
}

TEST(Arch, ArcsMeetAndBoundTheOpening) {
  for (const Opening& o :
       {Opening{1, 2.2, 0, 2, 0.5, ArchHead::basket}, Opening{1, 2.2, 0, 2, 0.9, ArchHead::pointed},
        Opening{1, 2.2, 0, 2, 0.3, ArchHead::circular}, Opening{1, 2.2, 0, 2, 0.6, ArchHead::circular}}) {
    const std::vector<ArchArc> arcs = arcs_of(o);
    ASSERT_EQ(arcs.size(), o.head == ArchHead::basket ? 3u : o.head == ArchHead::pointed ? 2u : 1u);
    FlatPoint last{o.right, o.springing};
    double top = 0;
    for (const ArchArc& arc : arcs) {
      for (int i = 0; i <= 20; ++i) {
        const double angle = arc.from_deg + (arc.to_deg - arc.from_deg) * i / 20;
        const SinCos turn = sin_cos_deg(angle);
        const auto at = [&](double r) { return FlatPoint{arc.centre.x + r * turn.cos, arc.centre.y + r * turn.sin}; };
        if (i == 0) {
          EXPECT_NEAR(at(arc.radius).x, last.x, 1e-9);
          EXPECT_NEAR(at(arc.radius).y, last.y, 1e-9);
        }
        top = std::max(top, at(arc.radius).y);
        if (i == 20) last = at(arc.radius);
        if (i == 0 || i == 20) continue;
        EXPECT_TRUE(contains(o, at(arc.radius - 1e-6))) << angle;
        EXPECT_FALSE(contains(o, at(arc.radius + 1e-6))) << angle;
      }
    }
    EXPECT_NEAR(last.x, o.left, 1e-9);
    EXPECT_NEAR(last.y, o.springing, 1e-9);
    EXPECT_NEAR(top, o.springing + o.rise, 2e-2);
  }
}

}  // namespace
}  // namespace ilot::scan
