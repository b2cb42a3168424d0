// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/plane_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(FitPlane, ExactPlaneFarFromTheOrigin) {
  // 3x + 4z = const on integer points: no rounding in the data, so the fit must be exact to double precision.
  Moments m;
  const std::int64_t far = 7000000000;
  for (std::int64_t i = 0; i < 40; ++i)
    for (std::int64_t j = 0; j < 40; ++j) m.add_point({far + 4 * i, far + j, 1000 - 3 * i});
  const PlaneFit fit = fit_plane(m);
  ASSERT_TRUE(fit.unique);
  EXPECT_NEAR(fit.plane.n.x, 0.6, 1e-14);
  EXPECT_NEAR(fit.plane.n.y, 0.0, 1e-14);
  EXPECT_NEAR(fit.plane.n.z, 0.8, 1e-14);
  EXPECT_LT(fit.rms, 1e-6);
}

TEST(FitPlane, DegenerateSetsHaveNoPlane) {
  Moments m;
  EXPECT_FALSE(fit_plane(m).unique);
  for (std::int64_t i = 0; i < 10; ++i) m.add_point({i, 2 * i, -i});
  EXPECT_FALSE(fit_plane(m).unique);
}

TEST(RmsToPlane, EqualsTheSumOverPoints) {
  Rng rng(5);
  Moments m;
  std::vector<Index3> points;
  for (int i = 0; i < 500; ++i) {
    points.push_back({static_cast<std::int64_t>(rng.below(1000)), static_cast<std::int64_t>(rng.below(1000)),
                      static_cast<std::int64_t>(rng.below(30))});
    m.add_point(points.back());
  }
  const Plane plane{{0.36, 0.48, 0.8}, -500};
  double sum = 0;
  for (const Index3& p : points) {
    const double d =
        signed_distance(plane, {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
    sum += d * d;
  }
  EXPECT_NEAR(rms_to_plane(m, plane), std::sqrt(sum / 500), 1e-9);
  const PlaneFit fit = fit_plane(m);
  EXPECT_NEAR(rms_to_plane(m, fit.plane), fit.rms, 1e-9);
  EXPECT_LE(fit.rms, rms_to_plane(m, plane));
}

}  // namespace
}  // namespace ilot
