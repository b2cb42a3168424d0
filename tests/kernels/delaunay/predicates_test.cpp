// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

using Big = boost::multiprecision::cpp_int;

Big big_in_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto row = [&](Point2 p) {
    const Big x = Big(p.x) - d.x, y = Big(p.y) - d.y;
    return std::array<Big, 3>{x, y, x * x + y * y};
  };
  const auto u = row(a), v = row(b), w = row(c);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

TEST(Predicates, OrientationOfThreePoints) {
  EXPECT_EQ(orient2d(Point2{0, 0}, {4, 0}, {0, 3}), 12);
  EXPECT_EQ(orient2d(Point2{0, 0}, {0, 3}, {4, 0}), -12);
  EXPECT_EQ(orient2d(Point2{1, 1}, {2, 3}, {3, 5}), 0);
}

TEST(Predicates, TheWholeRangeIsExact) {
  const std::int32_t far = kMaxPlaneCoordinate;
  EXPECT_EQ(orient2d(Point2{-far, -far}, {far, -far}, {far, far}), std::int64_t{1} << 60);
  EXPECT_EQ(orient2d(Point2{-far, -far}, {far, far}, {far, far - 1}), -(std::int64_t{1} << 30));
  EXPECT_TRUE(in_circle({-far, -far}, {far, -far}, {far, far}, {-far + 1, far}));
  EXPECT_TRUE(in_circle({-far, -far}, {far, -far}, {-far, far}, {far, far - 1}));
  EXPECT_FALSE(in_circle({-far, -far}, {far, -far}, {far, far - 1}, {-far, far}));
}

TEST(Predicates, InCircleAgreesWithArithmeticOfAnySize) {
  Rng rng(5);
  std::size_t ties = 0;
  for (const std::int32_t reach : {3, 1000, kMaxPlaneCoordinate})
    for (int i = 0; i < 5000; ++i) {
      std::array<Point2, 4> p;
      for (Point2& q : p) q = {test::draw_within(rng, reach), test::draw_within(rng, reach)};
      if (orient2d(p[0], p[1], p[2]) <= 0 || p[3] == p[0] || p[3] == p[1] || p[3] == p[2]) continue;
      const Big exact = big_in_circle(p[0], p[1], p[2], p[3]);
      if (exact == 0)
        ++ties;
      else
        EXPECT_EQ(in_circle(p[0], p[1], p[2], p[3]), exact > 0);
    }
  EXPECT_GT(ties, 50u);
}

// Of four points on a circle exactly one diagonal is right, from all twelve triangles that turn left, in the order of
// their corners whatever: the one that cuts off the largest point.
TEST(Predicates, FourPointsOnACircleHaveOneAnswer) {
  std::array<Point2, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<Point2, 4> circle{{{25, 0}, {7, 24}, {-15, 20}, {-7, -24}}};
  for (auto p : {square, circle}) {
    const Point2 largest = *std::max_element(p.begin(), p.end());
    std::sort(p.begin(), p.end());
    std::size_t triangles = 0;
    do {
      if (orient2d(p[0], p[1], p[2]) <= 0) continue;
      if (p[3] == largest) {
        EXPECT_FALSE(in_circle(p[0], p[1], p[2], p[3]));
      }
      triangles += !in_circle(p[0], p[1], p[2], p[3]);
    } while (std::next_permutation(p.begin(), p.end()));
    EXPECT_EQ(triangles, 6u);  // two triangles, three rotations each
  }
}

TEST(Predicates, TiesDoNotDependOnAShift) {
  Rng rng(6);
  for (int i = 0; i < 20000; ++i) {
    std::array<Point2, 4> p, q;
    const Point2 by{test::draw_within(rng, 400000000), test::draw_within(rng, 400000000)};
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = {test::draw_within(rng, 3), test::draw_within(rng, 3)};
      q[k] = {p[k].x + by.x, p[k].y + by.y};
    }
    if (orient2d(p[0], p[1], p[2]) <= 0 || p[3] == p[0] || p[3] == p[1] || p[3] == p[2]) continue;
    EXPECT_EQ(in_circle(p[0], p[1], p[2], p[3]), in_circle(q[0], q[1], q[2], q[3]));
  }
}

}  // namespace
}  // namespace ilot
