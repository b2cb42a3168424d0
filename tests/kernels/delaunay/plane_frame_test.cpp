// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/plane_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(PlaneFrame, AFacadeStandsUpright) {
  const PlaneFrame f = frame_of({{0, -1, 0}, 50}, {7, 40, 3});  // y = 50, seen from the south
  EXPECT_EQ(f.origin.y, 50);
  EXPECT_EQ(f.u.x, 1);
  EXPECT_EQ(f.v.z, 1);
  EXPECT_EQ(project(f, {8, 50, 5}), (Point2{4, 8}));
}

TEST(PlaneFrame, GroundHasEastToTheRightAndNorthUp) {
  const PlaneFrame f = frame_of({{0, 0, 1}, -2}, {0, 0, 0});
  EXPECT_EQ(project(f, {3, 4, 9}), (Point2{12, 16}));
}

TEST(PlaneFrame, AxesAreOrthonormalAndPositionsComeBackWithinHalfAStep) {
  Rng rng(3);
  const auto draw = [&] { return 2 * rng.uniform() - 1; };
  for (int i = 0; i < 2000; ++i) {
    Vec3 n{draw(), draw(), i % 3 == 0 ? 300 * draw() : draw()};
    n = (1 / norm(n)) * n;
    const PlaneFrame f = frame_of({n, 100 * draw()}, {100 * draw(), 100 * draw(), 100 * draw()});
    for (const double d : {dot(f.u, f.v), dot(f.v, f.n), dot(f.n, f.u), norm(f.u) - 1, norm(f.v) - 1})
      EXPECT_NEAR(d, 0, 1e-12);
    EXPECT_GT(dot(cross(f.u, f.v), f.n), 0.99);
    const Vec3 on = f.origin + (1000 * draw()) * f.u + (1000 * draw()) * f.v;
    const Vec3 off = position(f, project(f, on + draw() * f.n)) - on;
    EXPECT_LE(std::max(std::abs(dot(off, f.u)), std::abs(dot(off, f.v))), 0.5 / kPlaneSteps + 1e-9);
    EXPECT_NEAR(dot(off, f.n), 0, 1e-9);
  }
}

}  // namespace
}  // namespace ilot
