// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/closest.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

Vec3 random_point(Rng& rng, double size) {
  const double x = rng.uniform(), y = rng.uniform(), z = rng.uniform();
  return {size * (x - 0.5), size * (y - 0.5), size * (z - 0.5)};
}

// Least distance to a grid of points of the triangle, corners included.
double sampled_distance(Vec3 p, const Triangle3& t, int steps) {
  double best = norm(p - t.a);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      best = std::min(best, norm(p - (t.a + u * (t.b - t.a) + v * (t.c - t.a))));
    }
  return best;
}

TEST(Closest, FindsFaceEdgeAndCorner) {
  const Triangle3 t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Vec3 inside = closest_on_triangle({1, 1, 3}, t), edge = closest_on_triangle({2, -5, 1}, t);
  const Vec3 corner = closest_on_triangle({9, -1, 1}, t);
  EXPECT_EQ(norm(inside - Vec3{1, 1, 0}), 0);
  EXPECT_EQ(norm(edge - Vec3{2, 0, 0}), 0);
  EXPECT_EQ(norm(corner - Vec3{4, 0, 0}), 0);
}

TEST(Closest, IsNoFartherThanAnySampleAndLiesOnTheTriangle) {
  Rng rng(1);
  for (int round = 0; round < 300; ++round) {
    const Triangle3 t{random_point(rng, 2), random_point(rng, 2), random_point(rng, 2)};
    const Vec3 p = random_point(rng, 6), q = closest_on_triangle(p, t);
    EXPECT_LE(norm(p - q), sampled_distance(p, t, 40) + 1e-12);
    const double whole = norm(cross(t.b - t.a, t.c - t.a));
    const double parts = norm(cross(t.a - q, t.b - q)) + norm(cross(t.b - q, t.c - q)) + norm(cross(t.c - q, t.a - q));
    EXPECT_NEAR(parts, whole, 1e-12);
  }
}

TEST(Closest, TrianglesWithoutAreaAreTheirEdges) {
  const Triangle3 line{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, point{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}};
  EXPECT_EQ(norm(closest_on_triangle({2, 1, 0}, line) - Vec3{2, 0, 0}), 0);
  EXPECT_EQ(norm(closest_on_triangle({7, 1, 0}, line) - Vec3{3, 0, 0}), 0);
  EXPECT_EQ(norm(closest_on_triangle({7, 1, 0}, point) - Vec3{2, 2, 2}), 0);
  EXPECT_EQ(norm(closest_on_segment({7, 1, 0}, {1, 1, 1}, {1, 1, 1}) - Vec3{1, 1, 1}), 0);
}

}  // namespace
}  // namespace ilot
