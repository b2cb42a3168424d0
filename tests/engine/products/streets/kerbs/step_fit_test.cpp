// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/kerbs/step_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

struct TestStep {
  double angle_deg = 0, at = 0, height = 0.12;  // across the edge; of the edge from the middle
  double slope = 0.1;                           // along the edge
  double low_slope = -0.03, up_slope = 0.02;    // away from the edge
};

std::vector<GroundPoint> step_points(const TestStep& step, double noise, std::uint64_t seed, double radius = 0.4) {
  const double a = step.angle_deg * 3.14159265358979 / 180, ux = std::cos(a), uy = std::sin(a);
  Rng rng(seed);
  std::vector<GroundPoint> points;
  for (double x = -radius; x <= radius; x += 0.05)
    for (double y = -radius; y <= radius; y += 0.05) {
      const double u = x + 0.04 * rng.uniform(), v = y + 0.04 * rng.uniform();
      if (u * u + v * v > radius * radius) continue;
      const double t = u * ux + v * uy - step.at, s = v * ux - u * uy;
      const double z = step.slope * s + (t < 0 ? step.low_slope * t : step.height + step.up_slope * t);
      points.push_back({u, v, z + noise * (rng.uniform() - 0.5)});
    }
  return points;
}

TEST(StepFit, EdgeAndHeightInAllDirections) {
  for (const double angle : {0.0, 33.0, 90.0, 178.0, 250.0})
    for (const double height : {0.05, 0.12, 0.25})
      for (const double at : {-0.1, 0.0, 0.08}) {
        const TestStep step{angle, at, height};
        const auto fit = fit_step(step_points(step, 0.01, 3), {});
        ASSERT_TRUE(fit) << angle << " " << height << " " << at;
        EXPECT_NEAR(fit->height, height, 0.012) << angle << " " << at;
        const double a = angle * 3.14159265358979 / 180;
        EXPECT_GT(fit->up_x * std::cos(a) + fit->up_y * std::sin(a), 0.98) << angle << " " << height << " " << at;
        EXPECT_NEAR(fit->x * std::cos(a) + fit->y * std::sin(a), at, 0.03) << angle << " " << height;
      }
}

TEST(StepFit, NoStepOnPlanesRampsAndRoughGround) {
  EXPECT_FALSE(fit_step(step_points({20, 0, 0, 0.18}, 0.02, 1), {}));          // a steep street
  EXPECT_FALSE(fit_step(step_points({20, 0, 0, 0.1, 0.03, 0.03}, 0, 2), {}));  // a gutter
  EXPECT_FALSE(fit_step(step_points({20, 0, 0.02}, 0.01, 3), {}));             // lower than a kerb
  EXPECT_FALSE(fit_step(step_points({20, 0, 0.5}, 0.01, 4), {}));              // a wall
  EXPECT_FALSE(fit_step(step_points({20, 0, 0}, 0.3, 5), {}));                 // a lawn
  EXPECT_FALSE(fit_step({}, {}));
}

// The lowest points of a wall are above the ground, but there is no surface up there.
TEST(StepFit, TheFootOfAWallIsNone) {
  std::vector<GroundPoint> points;
  for (double x = -0.4; x < 0.4; x += 0.04) {
    for (double y = -0.3; y < 0; y += 0.04) points.push_back({x, y, 0});
    for (double z = 0; z < 0.2; z += 0.04) points.push_back({x, 0.01, z});
  }
  EXPECT_FALSE(fit_step(points, {}));
}

TEST(StepFit, TheOrderOfTheDirectionsDoesNotTurnTheAnswer) {
  std::vector<GroundPoint> points = step_points({40, 0.05, 0.1}, 0.01, 8);
  const auto fit = fit_step(points, {});
  for (GroundPoint& p : points) p.x = -p.x, p.y = -p.y;
  const auto turned = fit_step(points, {});
  ASSERT_TRUE(fit && turned);
  EXPECT_NEAR(fit->x, -turned->x, 0.02);
  EXPECT_NEAR(fit->height, turned->height, 0.01);
}

}  // namespace
}  // namespace ilot
