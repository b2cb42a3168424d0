// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/moments.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/point_sets.h"

namespace ilot {
namespace {

TEST(Moments, AreExactWhateverTheOrderSplitOrAnchor) {
  const auto set = test::point_sets(1000)[1];
  std::vector<std::uint32_t> all(1000);
  std::iota(all.begin(), all.end(), 0u);
  const Moments whole = moments_of(set.view(), all);
  Moments parts = moments_of(set.view(), std::span(all).first(300));
  parts.add(moments_of(set.view(), std::span(all).subspan(300)));
  EXPECT_EQ(whole, parts);
  Moments one_by_one, moved;
  const Index3 by{7000000000, -123456789, 42};
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Index3 p{static_cast<std::int64_t>(set.x[999 - i]), static_cast<std::int64_t>(set.y[999 - i]),
                   static_cast<std::int64_t>(set.z[999 - i])};
    one_by_one.add_point(p);
    moved.add_point({p.x + by.x, p.y + by.y, p.z + by.z});
  }
  EXPECT_EQ(whole, one_by_one);
  EXPECT_EQ(shifted(whole, by), moved);
  EXPECT_EQ(shifted(moved, {-by.x, -by.y, -by.z}), whole);
}

TEST(Moments, CentroidAndCovarianceByHand) {
  Moments m;
  m.add_point({0, 0, 0});
  m.add_point({4, 0, 0});
  m.add_point({0, 2, 0});
  m.add_point({4, 2, 0});
  EXPECT_EQ(centroid(m).x, 2);
  EXPECT_EQ(centroid(m).y, 1);
  const Symmetric3 c = covariance(m);
  EXPECT_EQ(c.xx, 4);
  EXPECT_EQ(c.yy, 1);
  EXPECT_EQ(c.xy, 0);
  EXPECT_EQ(c.zz, 0);
}

// n^2 covariance out of sums is exact, so points in one place have none at all, however far away.
TEST(Moments, PointsInOnePlaceOnALineAndOnAPlaneAreExactlyDegenerate) {
  const Index3 far{(std::int64_t{1} << 31) - 1, -(std::int64_t{1} << 31) + 1, 7};
  Moments one, line, plane;
  for (int i = 0; i < 1000; ++i) {
    one.add_point(far);
    line.add_point({far.x - 3 * i, far.y + 2 * i, far.z});
    plane.add_point({far.x - i % 37, far.y + i / 37, far.z});
  }
  const Symmetric3 none = covariance(one);
  for (const double v : {none.xx, none.xy, none.xz, none.yy, none.yz, none.zz}) EXPECT_EQ(v, 0);
  EXPECT_EQ(centroid(one).x, static_cast<double>(far.x));
  const Symmetric3 l = covariance(line);
  EXPECT_EQ(l.xx * 4, l.yy * 9);
  EXPECT_EQ(l.xy * -3, l.xx * 2);
  EXPECT_EQ(l.zz, 0);
  EXPECT_EQ(covariance(plane).zz, 0);
  EXPECT_EQ(covariance(plane).xz, 0);
}

TEST(Moments, NothingIsTheNeutralElement) {
  EXPECT_EQ(moments_of({}, {}), Moments{});
  EXPECT_EQ(shifted({}, {5, -6, 7}), Moments{});
  Moments m;
  m.add_point({1, 2, 3});
  const Moments before = m;
  m.add({});
  EXPECT_EQ(m, before);
}

TEST(Moments, HoldTheLargestCoordinatesAndCounts) {
  // 2^22 - 1 in float32, as many points as the header allows: the 64-bit sums inside just fit.
  constexpr std::uint32_t n = (1u << 19) - 1;
  std::vector<float> edge(16, -static_cast<float>((1 << 22) - 1));
  const std::vector<std::uint32_t> same(n, 0u);
  const Moments m = moments_of({edge.data(), edge.data(), edge.data(), 1}, same);
  constexpr std::int64_t v = (1 << 22) - 1;
  EXPECT_TRUE(m.x == -Int128{v} * n && m.yz == Int128{v} * v * n);
  // 2^31 - 1 and 2^59 points by doubling.
  Moments big;
  big.add_point({(std::int64_t{1} << 31) - 1, 1, 0});
  for (int i = 0; i < 59; ++i) big.add(Moments(big));
  EXPECT_EQ(big.n, std::int64_t{1} << 59);
  EXPECT_TRUE(big.xx == (Int128{1} << 59) * ((Int128{1} << 31) - 1) * ((Int128{1} << 31) - 1));
  EXPECT_EQ(centroid(big).x, 2147483647.0);
}

TEST(Moments, CovarianceDoesNotChangeWithTheAnchor) {
  const auto set = test::point_sets(300)[1];
  std::vector<std::uint32_t> all(300);
  std::iota(all.begin(), all.end(), 0u);
  const Moments m = moments_of(set.view(), all);
  const Symmetric3 here = covariance(m), there = covariance(shifted(m, {-1999999999, 1234567890, 3}));
  EXPECT_EQ(here.xx, there.xx);
  EXPECT_EQ(here.xy, there.xy);
  EXPECT_EQ(here.yz, there.yz);
  EXPECT_EQ(here.zz, there.zz);
}

}  // namespace
}  // namespace ilot
