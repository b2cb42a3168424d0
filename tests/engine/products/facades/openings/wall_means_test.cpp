// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/wall_means.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr MeanLimits kAllAbout{-0.15, 0.15, -0.15, 0.15};

WallMeans means_with_noise(double noise, bool turned = false) {
  test::ScannedWall wall;
  wall.wall({});
  FacadeSite site = test::scan_wall(wall, {3, 1.5, 8}, 0.002, 999, noise);
  if (turned) std::reverse(site.points.begin(), site.points.end());
  const RaySamples samples(site);
  return means_about_cells(samples, trend_surface(samples), wall_grid(site), kAllAbout);
}

TEST(WallMeans, ASmoothWallShowsTheLeastStepAndARoughOneLessThanTwiceItsScatter) {
  EXPECT_DOUBLE_EQ(means_with_noise(0.002).step, kLeastStep);
  const WallMeans rough = means_with_noise(0.02);
  EXPECT_LT(rough.step, kStepOfNoise * 0.02);
  EXPECT_LT(rough.scatter, 0.02 / 2);  // of four points and more
  // Hardly a mean of the wall lies behind the middle of the step.
  std::size_t cells = 0, wrong = 0;
  for (std::size_t i = 0; i < rough.points.size(); ++i)
    if (rough.has(i)) ++cells, wrong += static_cast<double>(rough.mean[i]) < -rough.step / 2;
  EXPECT_LT(wrong, cells / 30);
}

TEST(WallMeans, TheOrderOfThePointsDoesNotMatter) {
  const WallMeans one = means_with_noise(0.02), other = means_with_noise(0.02, true);
  EXPECT_EQ(one.mean, other.mean);
  EXPECT_EQ(one.points, other.points);
}

}  // namespace
}  // namespace ilot
