// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/flat.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"
#include "kernels/geometry/closest.h"

namespace ilot {
namespace {

TEST(Flat, DistanceToAnEdge) {
  const FlatEdge edge{{0, 0}, {4, 0}};
  EXPECT_EQ(squared_distance({2, 3}, edge), 9);
  EXPECT_EQ(squared_distance({-3, 4}, edge), 25);
  EXPECT_EQ(squared_distance({5, 0}, edge), 1);
  EXPECT_EQ(squared_distance({1, 0}, edge), 0);
  EXPECT_EQ(squared_distance({4, 5}, FlatEdge{{1, 1}, {1, 1}}), 25);
}

TEST(Flat, DistanceToAnEdgeIsThatInSpace) {
  Rng rng(5);
  const auto draw = [&] { return FlatPoint{rng.uniform(), rng.uniform()}; };
  const auto lifted = [](FlatPoint p) { return Vec3{p.x, p.y, 0}; };
  for (int i = 0; i < 200; ++i) {
    const FlatPoint p = draw(), a = draw(), b = draw();
    const Vec3 nearest = closest_on_segment(lifted(p), lifted(a), lifted(b));
    EXPECT_NEAR(std::sqrt(squared_distance(p, {a, b})), norm(lifted(p) - nearest), 1e-12);
  }
}

TEST(Flat, TurnsAndLengths) {
  EXPECT_EQ(orient2d(FlatPoint{0, 0}, FlatPoint{3, 0}, FlatPoint{0, 2}), 6);
  EXPECT_EQ(orient2d(FlatPoint{0, 0}, FlatPoint{0, 2}, FlatPoint{3, 0}), -6);
  EXPECT_EQ(distance(FlatPoint{1, 1}, FlatPoint{4, 5}), 5);
  EXPECT_EQ(squared_distance(FlatPoint{1, 1}, FlatPoint{4, 5}), 25);
}

}  // namespace
}  // namespace ilot
