// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/misalignment.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Misalignment, EachShiftHasThePointsThatItCovers) {
  const SitePolygon court{kHouse[0], {{3000, 2000}, {3000, 6000}, {7000, 6000}, {7000, 2000}}};
  const SitePolygon beside{{{10500, 1000}, {12000, 1000}, {12000, 3000}, {10500, 3000}}};
  const std::vector<Vec3> points = points_on_house(0.3, -0.4);
  ShiftCounts counts;
  count_shifts(points, std::vector<SitePolygon>{court, beside}, counts);
  const auto covered = [](double x, double y) {
    const bool in_house = x > 0 && x < 10 && y > 0 && y<8, in_court = x> 3 && x < 7 && y > 2 && y < 6;
    return (in_house && !in_court) || (x > 10.5 && x < 12 && y > 1 && y < 3);
  };
  for (const int dy : {-kShiftReach, -3, 0, 5, kShiftReach})
    for (const int dx : {-kShiftReach, -1, 0, 2, kShiftReach}) {
      std::uint64_t expected = 0;
      for (const Vec3& p : points)
        expected += covered((std::floor(p.x / kShiftStep) - dx + 0.5) * kShiftStep,
                            (std::floor(p.y / kShiftStep) - dy + 0.5) * kShiftStep);
      EXPECT_EQ(counts.inside[static_cast<std::size_t>((dy + kShiftReach) * kShifts + dx + kShiftReach)], expected)
          << dx << ", " << dy;
    }
}

TEST(Misalignment, WithoutPointsNothingIsKnown) {
  EXPECT_EQ(misalignment_of({}).inside, 0);
  ShiftCounts counts;
  count_shifts({}, {}, counts);
  EXPECT_EQ(counts.points, 0u);
}

}  // namespace
}  // namespace ilot
