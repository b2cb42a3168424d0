// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/plane_errors.h"

#include <gtest/gtest.h>

#include <numbers>

namespace ilot {
namespace {

Segment segment(std::uint32_t id, Vec3 n, Vec3 centroid) {
  Segment s;
  s.id = id;
  s.plane = {n, -dot(n, centroid)};
  s.centroid = centroid;
  return s;
}

TEST(PlaneErrors, MeasuresAngleAndOffsetEitherWayRound) {
  const double a = std::numbers::pi / 180;  // a degree
  const std::vector<TruePlane> truth{{1, "wall", {{0, 0, 1}, -5}, {}}, {2, "wall", {{0, -1, 0}, 3}, {}}};
  const std::vector<Segment> found{segment(7, {std::sin(a), 0, std::cos(a)}, {100, 50, 5.02}),
                                   segment(8, {0, 1, 0}, {4, 2.99, 9})};
  const std::vector<PlaneMatch> matches{{1, 7, 10}, {2, 8, 10}, {3, 9, 1}};
  const PlaneErrors e = plane_errors(matches, truth, found);
  EXPECT_EQ(e.planes, 2u);
  EXPECT_NEAR(e.angle_deg.mean, 0.5, 1e-12);
  EXPECT_NEAR(e.angle_deg.largest, 1, 1e-12);
  EXPECT_NEAR(e.angle_deg.median, 0, 1e-12);
  EXPECT_NEAR(e.offset_m.mean, 0.015, 1e-12);
  EXPECT_NEAR(e.offset_m.largest, 0.02, 1e-12);
  EXPECT_NEAR(plane_errors(matches, truth, found, 0.3048).offset_m.largest, 0.02 * 0.3048, 1e-12);
}

TEST(PlaneErrors, OfNothingAreNothing) {
  EXPECT_EQ(plane_errors({}, {}, {}).planes, 0u);
  EXPECT_EQ(plane_errors({}, {}, {}).angle_deg.largest, 0);
}

}  // namespace
}  // namespace ilot
