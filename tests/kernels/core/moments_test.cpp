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

}  // namespace
}  // namespace ilot
