// SPDX-License-Identifier: Apache-2.0
#include "engine/visibility/closest_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

Vec3 random_point(Rng& rng, Vec3 at, double size) {
  const double x = rng.uniform(), y = rng.uniform(), z = rng.uniform();
  return at + Vec3{size * x, size * y, size * z};
}

std::vector<Triangle3> random_triangles(int count, Vec3 at, double size, double side) {
  Rng rng(11);
  std::vector<Triangle3> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec3 a = random_point(rng, at, size);
    triangles.push_back({a, random_point(rng, a, side), random_point(rng, a, side)});
  }
  return triangles;
}

// Anchored like the class, so that the arithmetic is the same.
void expect_as_brute_force(const std::vector<Triangle3>& triangles, Vec3 at, double size, double tolerance) {
  const ClosestPoint index(triangles);
  Rng rng(12);
  for (int i = 0; i < 400; ++i) {
    const Vec3 p = random_point(rng, at - Vec3{size, size, size}, 3 * size);
    double best = std::numeric_limits<double>::infinity();
    for (const Triangle3& t : triangles)
      best = std::min(best, norm(p - (closest_on_triangle(p - at, {t.a - at, t.b - at, t.c - at}) + at)));
    const SurfacePoint found = index.nearest(p);
    ASSERT_NE(found.triangle, kNoTriangle);
    EXPECT_NEAR(std::sqrt(found.squared_distance), best, tolerance);
    EXPECT_NEAR(norm(p - found.point), best, tolerance);
  }
}

TEST(ClosestPoint, AgreesWithBruteForce) {
  expect_as_brute_force(random_triangles(1, {0, 0, 0}, 10, 5), {0, 0, 0}, 10, 1e-9);
  expect_as_brute_force(random_triangles(700, {0, 0, 0}, 10, 1), {0, 0, 0}, 10, 1e-9);
  expect_as_brute_force(random_triangles(300, {0, 0, 0}, 0.01, 0.001), {0, 0, 0}, 0.01, 1e-12);
}

TEST(ClosestPoint, AgreesFarFromTheOrigin) {
  // Coordinates near 7e6 are multiples of 2^-30 m: sums of some of them stay within 1e-8.
  const Vec3 at{652000, 6862000, 40};
  expect_as_brute_force(random_triangles(500, at, 100, 8), at, 100, 1e-8);
}

TEST(ClosestPoint, TiesGoToTheSmallerTriangle) {
  const Triangle3 t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const std::size_t copies : {2u, 9u, 40u}) {
    const ClosestPoint index(std::vector<Triangle3>(copies, t));
    EXPECT_EQ(index.nearest({0.2, 0.2, 3}).triangle, 0u);
    EXPECT_EQ(index.nearest({-2, -2, -1}).triangle, 0u);
  }
}

TEST(ClosestPoint, StopsAtItsReach) {
  const ClosestPoint index(std::vector<Triangle3>{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  EXPECT_EQ(index.nearest({1, 1, 2}, 1.999).triangle, kNoTriangle);
  EXPECT_EQ(index.nearest({1, 1, 2}, 2).triangle, 0u);
  EXPECT_EQ(index.nearest({1, 1, 0}, 0).triangle, 0u);
  EXPECT_EQ(index.nearest({1, 1, 2}, -1).triangle, kNoTriangle);
  EXPECT_EQ(ClosestPoint(std::vector<Triangle3>{}).nearest({0, 0, 0}).triangle, kNoTriangle);
}

TEST(ClosestPoint, AnswersManyThreadsAlike) {
  const ClosestPoint index(random_triangles(2000, {0, 0, 0}, 50, 2));
  std::vector<SurfacePoint> one(5000), three(5000);
  const auto ask = [&](std::vector<SurfacePoint>& out) {
    parallel_for(out.size(), [&](std::size_t i) {
      Rng rng(13, i);
      out[i] = index.nearest(random_point(rng, {-10, -10, -10}, 70));
    });
  };
  with_threads(1, [&] { ask(one); });
  with_threads(3, [&] { ask(three); });
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].triangle, three[i].triangle);
    EXPECT_EQ(one[i].squared_distance, three[i].squared_distance);
  }
}

}  // namespace
}  // namespace ilot
