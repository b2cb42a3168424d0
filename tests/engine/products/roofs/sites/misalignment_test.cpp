// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/misalignment.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

const SitePolygon kHouse{{{0, 0}, {10000, 0}, {10000, 8000}, {0, 8000}}};

std::vector<Vec3> points_on_house(double dx, double dy) {
  Rng rng(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) points.push_back({dx + 10 * rng.uniform(), dy + 8 * rng.uniform(), 5});
  return points;
}

TEST(Misalignment, OutlinesThatLieRightStay) {
  ShiftCounts counts;
  count_shifts(points_on_house(0, 0), std::vector<SitePolygon>{kHouse}, counts);
  const Misalignment m = misalignment_of(counts);
  EXPECT_EQ(m.dx_m, 0);
  EXPECT_EQ(m.dy_m, 0);
  EXPECT_GT(m.inside, 0.999);
}

TEST(Misalignment, AShiftIsFound) {
  ShiftCounts all;
  for (int n = 0; n < 3; ++n) {
    ShiftCounts counts;
    count_shifts(points_on_house(1, -0.75), std::vector<SitePolygon>{kHouse}, counts);
    add(all, counts);
  }
  const Misalignment m = misalignment_of(all);
  EXPECT_NEAR(m.dx_m, 1, 1e-9);
  EXPECT_NEAR(m.dy_m, -0.75, 1e-9);
  EXPECT_LT(m.inside, 0.85);
  EXPECT_GT(m.inside_moved, 0.999);
}

TEST(Misalignment, WithoutPointsNothingIsKnown) {
  EXPECT_EQ(misalignment_of({}).inside, 0);
  ShiftCounts counts;
  count_shifts({}, {}, counts);
  EXPECT_EQ(counts.points, 0u);
}

}  // namespace
}  // namespace ilot
