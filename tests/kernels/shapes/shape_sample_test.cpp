// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_sample.h"

#include <gtest/gtest.h>

#include "kernels/shapes/shape_ransac.h"
#include "tests/support/shape_sets.h"

namespace ilot {
namespace {

ShapeSample sample_of(const Shape& s, Rng& rng) {
  ShapeSample r;
  for (OrientedPoint& q : r) {
    const double along = s.kind == ShapeKind::kSphere ? 1.8 * rng.uniform() - 0.9 : 300 + 500 * rng.uniform();
    const auto [p, n] = test::point_on(s, rng.uniform(), along);
    q = {p, rng.uniform() < 0.5 ? n : -1.0 * n};  // normals have no side
  }
  return r;
}

TEST(ShapeSample, ExactPointsGiveTheExactShape) {
  Rng rng(1);
  const Shape wanted[]{{ShapeKind::kPlane, {10, 20, 30}, {0.6, 0, 0.8}},
                       test::sphere({500, -200, 300}, 250),
                       test::cylinder({100, 200, 300}, {1, 2, 3}, 120),
                       test::cone({100, 200, 300}, {1, -1, 2}, 0.5)};
  for (const Shape& w : wanted) {
    int made = 0;
    for (int i = 0; i < 100; ++i) {
      ShapeSample s = sample_of(w, rng);
      if (w.kind == ShapeKind::kPlane)
        for (OrientedPoint& q : s)
          q = {w.origin + (900 * rng.uniform()) * Vec3{0, 1, 0} + (900 * rng.uniform()) * Vec3{0.8, 0, -0.6}, w.axis};
      const auto got = sample_shape(w.kind, s, 1e-6, 0.999999);
      if (!got) continue;
      ++made;
      EXPECT_NEAR(got->radius, w.radius, 1e-6);
      EXPECT_NEAR(got->sine, w.sine, 1e-9);
      EXPECT_NEAR(view_of(*got, w.origin).distance,
                  w.kind == ShapeKind::kPlane || w.kind == ShapeKind::kCone ? 0 : -w.radius, 1e-6);
      if (w.kind != ShapeKind::kSphere) {
        EXPECT_NEAR(std::abs(dot(got->axis, w.axis)), 1, 1e-9);
      }
      if (w.kind == ShapeKind::kCone) {
        EXPECT_GT(dot(got->axis, w.axis), 0);
      }
    }
    EXPECT_GT(made, 60) << static_cast<int>(w.kind);  // the rest is too thin to tell
  }
}

TEST(ShapeSample, NothingFromPointsThatDoNotDetermineIt) {
  const Vec3 z{0, 0, 1};
  const ShapeSample same{{{{1, 2, 3}, z}, {{1, 2, 3}, z}, {{1, 2, 3}, z}}};
  const ShapeSample line{{{{0, 0, 0}, z}, {{1, 0, 0}, z}, {{5, 0, 0}, z}}};
  const ShapeSample flat{{{{0, 0, 0}, z}, {{1, 0, 0}, z}, {{0, 5, 0}, z}}};
  for (int k = 0; k < kShapeKinds; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    EXPECT_FALSE(sample_shape(kind, same, 1, 0));
    EXPECT_FALSE(sample_shape(kind, line, 1, 0));
    EXPECT_EQ(sample_shape(kind, flat, 1, 0).has_value(), kind == ShapeKind::kPlane);
  }
}

TEST(ShapeSample, TheThirdPointHasAVeto) {
  Rng rng(2);
  const Shape w = test::sphere({500, 500, 500}, 250);
  ShapeSample s = sample_of(w, rng);
  while (!sample_shape(w.kind, s, 1, 0.99)) s = sample_of(w, rng);
  s[2].p = s[2].p + 3.0 * s[2].n;
  EXPECT_FALSE(sample_shape(w.kind, s, 2.9, 0.99));
  EXPECT_TRUE(sample_shape(w.kind, s, 3.1, 0.99));
}

}  // namespace
}  // namespace ilot
