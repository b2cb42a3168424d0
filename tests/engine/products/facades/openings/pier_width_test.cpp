// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "engine/products/facades/openings/openings.h"
#include "engine/products/facades/openings/region_parts.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr Vec3 kPierEye{2, 1.6, 7};
constexpr double kPierStep = 0.009;  // tangents: rays 6 cm apart, cells of 13 cm

// Two windows beside each other; leaves that lie on the wall between them where `out` is not 0.
FacadeSite two_windows(double from, double between, double out) {
  test::ScannedWall wall;
  wall.wall({{2, -0.2, from - 1.2, from, 1, 2.6, 0}, {2, -0.2, from + between, from + between + 1.2, 1, 2.6, 0}});
  if (out > 0) wall.block(from, from + between, 1, 2.6, out, 2);
  return test::scan_wall(wall, kPierEye, kPierStep);
}

double width_between(const FacadeSite& site, double middle) {
  const RaySamples samples(site);
  const WallCells cells = wall_grid(site);
  const auto cell = [&](double at) { return static_cast<std::int64_t>(at / cells.cell); };
  return pier_width(samples, cells.cell, {cell(middle - 1), cell(middle + 1), cell(1.05), cell(2.5)}, cell(middle));
}

TEST(PierWidth, APierIsKnownToARayWhereverTheCellsAre) {
  for (double from = 2.6; from < 2.75; from += 0.03) {
    EXPECT_NEAR(width_between(two_windows(from, 0.24, 0), from + 0.12), 0.24, 0.04) << from;
    EXPECT_NEAR(width_between(two_windows(from, 0.24, 0.04), from + 0.12), 0.24, 0.04) << from;
    EXPECT_LT(width_between(two_windows(from, 0.08, 0), from + 0.04), kWidestBar) << from;
  }
}

TEST(PierWidth, LeavesOnANarrowPierDoNotJoinTheWindowsBesideIt) {
  for (double from = 2.6; from < 2.75; from += 0.03) {
    const FacadeSite site = two_windows(from, 0.24, 0.04);
    ASSERT_GT(wall_grid(site).cell, kWidestBar / 2);
    const RaySamples samples(site);
    EXPECT_EQ(find_openings(samples).size(), 2u) << from;
  }
}

}  // namespace
}  // namespace ilot
