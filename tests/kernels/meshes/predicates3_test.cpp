// SPDX-License-Identifier: Apache-2.0
#include "kernels/meshes/predicates3.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr Index3 kOrigin{0, 0, 0}, kX{4, 0, 0}, kY{0, 4, 0};
constexpr IndexTriangle kFlat{kOrigin, kX, kY};

TEST(Predicates3, GiveTheSide) {
  EXPECT_EQ(orient3d_sign(kOrigin, kX, kY, {1, 1, 1}), 1);
  EXPECT_EQ(orient3d_sign(kOrigin, kX, kY, {1, 1, -1}), -1);
  EXPECT_EQ(orient3d_sign(kOrigin, kX, kY, {9, -7, 0}), 0);
  EXPECT_EQ(orient2d_sign(kOrigin, kX, kY, 2), 1);
  EXPECT_EQ(orient2d_sign({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0), 1);
  EXPECT_EQ(orient2d_sign({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1), 1);
  EXPECT_EQ(widest_axis(kFlat), 2);
  EXPECT_EQ(widest_axis({kOrigin, kX, {8, 0, 0}}), -1);
}

TEST(Predicates3, AreExactAtTheLimit) {
  const std::int64_t m = kMaxSpaceCoordinate;
  EXPECT_EQ(orient3d_sign({-m, -m, -m}, {m, m, -m}, {-m, m, m}, {m, -m, m}), 1);
  EXPECT_EQ(orient3d_sign({-m, -m, 0}, {m, -m, 0}, {m, m, 0}, {-m, m, 0}), 0);
  EXPECT_EQ(orient3d_sign({-m, -m, 0}, {m, -m, 0}, {m, m, 0}, {-m, m, 1}), 1);
}

TEST(Predicates3, AreExactWhereVectorsGetLong) {
  for (std::int64_t m = (std::int64_t{1} << 20) - 2; m <= (std::int64_t{1} << 20) + 2; ++m) {
    for (const std::int64_t z : {-1, 0, 1}) {
      EXPECT_EQ(orient3d_sign({0, 0, 0}, {m, 0, m}, {0, m, m}, {m, m, 2 * m + z}), z) << m;
      EXPECT_EQ(orient3d_sign({0, 0, 0}, {-m, 0, -m}, {0, -m, -m}, {-1, -1, z - 2}), z) << m;
    }
  }
  EXPECT_EQ(orient3d_sign({0, 0, 0}, {0xfffff, 0xfffff, -0xfffff}, {-0xfffff, 0xfffff, 0xfffff},
                          {0xfffff, -0xfffff, 0xfffff}),
            1);
}

TEST(Predicates3, SegmentsMeetTriangles) {
  EXPECT_TRUE(segment_meets_triangle({1, 1, -3}, {1, 1, 5}, kFlat)) << "through the middle";
  EXPECT_TRUE(segment_meets_triangle({1, 1, 0}, {1, 1, 5}, kFlat)) << "ends on it";
  EXPECT_TRUE(segment_meets_triangle({2, 2, -1}, {2, 2, 1}, kFlat)) << "through an edge";
  EXPECT_TRUE(segment_meets_triangle({4, 0, -1}, {4, 0, 1}, kFlat)) << "through a corner";
  EXPECT_FALSE(segment_meets_triangle({3, 3, -1}, {3, 3, 1}, kFlat)) << "beside it";
  EXPECT_FALSE(segment_meets_triangle({1, 1, 1}, {1, 1, 5}, kFlat)) << "above it";
  EXPECT_TRUE(segment_meets_triangle({-1, 1, 0}, {5, 1, 0}, kFlat)) << "in its plane, across";
  EXPECT_TRUE(segment_meets_triangle({1, 1, 0}, {2, 1, 0}, kFlat)) << "in its plane, inside";
  EXPECT_TRUE(segment_meets_triangle({4, 0, 0}, {9, 0, 0}, kFlat)) << "in its plane, from a corner";
  EXPECT_FALSE(segment_meets_triangle({5, 0, 0}, {9, 0, 0}, kFlat)) << "in its plane, on an edge's line";
  EXPECT_FALSE(segment_meets_triangle({4, 1, 0}, {1, 4, 0}, kFlat)) << "in its plane, beside it";
}

TEST(Predicates3, TrianglesMeetEitherWayRound) {
  EXPECT_TRUE(triangles_meet(kFlat, {{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}));
  EXPECT_TRUE(triangles_meet({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, kFlat)) << "one within the other";
  EXPECT_FALSE(triangles_meet(kFlat, {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}));
}

// A point of both by a fine grid of barycentric weights: found means that they meet.
bool meet_by_points(const IndexTriangle& s, const IndexTriangle& t) {
  constexpr int kSteps = 12;
  for (int i = 0; i <= kSteps; ++i) {
    for (int k = 0; i + k <= kSteps; ++k) {
      const int l = kSteps - i - k;
      const auto at = [&](std::int64_t a, std::int64_t b, std::int64_t c) { return a * i + b * k + c * l; };
      const Index3 p{at(s.a.x, s.b.x, s.c.x), at(s.a.y, s.b.y, s.c.y), at(s.a.z, s.b.z, s.c.z)};
      const auto scaled = [](Index3 v) { return Index3{v.x * kSteps, v.y * kSteps, v.z * kSteps}; };
      if (segment_meets_triangle(p, p, {scaled(t.a), scaled(t.b), scaled(t.c)})) return true;
    }
  }
  return false;
}

TEST(Predicates3, AgreeWithPointsOnSmallLattices) {
  Rng rng(7);
  int met = 0, found = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto corner = [&] {
      return Index3{static_cast<std::int64_t>(rng.below(4)), static_cast<std::int64_t>(rng.below(4)),
                    static_cast<std::int64_t>(rng.below(4))};
    };
    const IndexTriangle s{corner(), corner(), corner()}, t{corner(), corner(), corner()};
    if (widest_axis(s) < 0 || widest_axis(t) < 0) continue;
    const bool meet = triangles_meet(s, t);
    EXPECT_EQ(meet, triangles_meet(t, s));
    EXPECT_EQ(meet, triangles_meet({s.c, s.b, s.a}, {t.b, t.c, t.a}));
    met += meet ? 1 : 0;
    if (!meet_by_points(s, t)) continue;
    ++found;
    EXPECT_TRUE(meet) << "round " << round;
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(met, found);
}

}  // namespace
}  // namespace ilot
