// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/padded_points.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(PaddedPoints, CanBeReadToTheNextWholeVector) {
  for (std::size_t n = 0; n < 40; ++n) {
    PaddedPoints points;
    for (std::size_t i = 0; i < n; ++i) points.add(static_cast<float>(i), 2, 3);
    points.pad();
    ASSERT_EQ(points.points().size, n);
    for (const auto* v : {&points.x, &points.y, &points.z}) {
      ASSERT_GE(v->size(), (n + 15) / 16 * 16);
      for (std::size_t i = n; i < v->size(); ++i) EXPECT_EQ((*v)[i], 0);
    }
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(points.points().x[i], static_cast<float>(i));
  }
}

TEST(PaddedPoints, ChosenPointsKeepTheirNormals) {
  PaddedOrientedPoints all, some;
  all.reset(3);
  EXPECT_EQ(all.nx.size(), 3 + kPointPadding);
  for (std::size_t i = 0; i < 3; ++i) {
    all.x[i] = static_cast<float>(i);
    all.nz[i] = static_cast<float>(10 * i);
  }
  some.add_from(all.oriented(), 2);
  some.add_from(all.oriented(), 1);
  some.pad();
  ASSERT_EQ(some.size, 2u);
  EXPECT_EQ(some.position(0).x, 2);
  EXPECT_EQ(some.normal(0).z, 20);
  EXPECT_EQ(some.normal(1).z, 10);
  EXPECT_EQ(some.nz.size(), 2 + kPointPadding);
}

}  // namespace
}  // namespace ilot
