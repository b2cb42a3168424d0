// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/pose.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

TEST(Pose, APlacedSolidMeetsPlacedRays) {
  const Pose pose{{3, -2, 1}, sin_cos_deg(35), sin_cos_deg(5)};
  const std::array<Solid, 3> solids{prism(std::array<Vec3, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0, 0, 1}, 1),
                                    cylinder({0, 0, 0}, {0, 0.6, 0.8}, 2, 0.5, 2), sphere({0.3, 0.2, 0.1}, 0.7, 3)};
  Rng rng(5);
  int met = 0;
  for (const Solid& solid : solids) {
    const Solid moved = placed(solid, pose);
    for (int i = 0; i < 500; ++i) {
      const Vec3 origin{4 * rng.uniform() - 2, 4 * rng.uniform() - 2, 4};
      const Vec3 aim{rng.uniform(), rng.uniform(), rng.uniform()};
      const Ray ray{origin, (1 / norm(aim - origin)) * (aim - origin)};
      const auto here = meet(ray, solid, 0),
                 there = meet({pose.place(origin), pose.direction(ray.direction)}, moved, 0);
      ASSERT_EQ(here.has_value(), there.has_value());
      if (!here) continue;
      ++met;
      EXPECT_NEAR(here->t, there->t, 1e-9);
      const Vec3 p = pose.place(point_at(ray, here->t));
      EXPECT_GE(p.x, moved.bounds.min.x - 1e-9);
      EXPECT_LE(p.z, moved.bounds.max.z + 1e-9);
    }
  }
  EXPECT_GT(met, 300);
}

TEST(Pose, PitchLiftsTheNose) {
  const Pose pose{{0, 0, 0}, {}, sin_cos_deg(10)};
  EXPECT_GT(pose.direction({1, 0, 0}).z, 0.17);
}

TEST(PlanBox, DistanceBetweenBoxes) {
  const PlanBox a{0, 0, {}, 2, 1}, b{5, 0, {}, 2, 1}, turned{4, 0, sin_cos_deg(90), 2, 1};
  EXPECT_FALSE(closer(a, b, 0.99));
  EXPECT_TRUE(closer(a, b, 1.01));
  EXPECT_FALSE(closer(a, turned, 0.99));
  EXPECT_TRUE(closer(a, turned, 1.01));
  EXPECT_FALSE(closer(a, {4, 0, {}, 2, 1}, -1e-9));  // side by side
  EXPECT_TRUE(closer(a, {3.9, 0, {}, 2, 1}, -1e-9));
  // Corner to side: two diamonds' tips.
  EXPECT_FALSE(closer({0, 0, sin_cos_deg(45), 1, 1}, {3, 0, {}, 1, 1}, 0.5));
}

}  // namespace
}  // namespace ilot::scan
