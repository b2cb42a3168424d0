// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/sides/located_edge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "engine/products/facades/sides/face_cluster.h"
#include "tests/support/facade_sites.h"
#include "tests/support/sampled_site.h"

namespace ilot {
namespace {

using test::ScannedWall;

constexpr double kLeft = 3, kRight = 4.2, kBottom = 1.2, kTop = 1.3, kOut = 0.08;
constexpr std::uint32_t kPlane = 2;

// The end of a sill as it is found, seen from there.
LocatedEdge end_of_sill(Vec3 eye, double step, Side side) {
  ScannedWall wall;
  wall.wall({});
  wall.block(kLeft, kRight, kBottom, kTop, kOut, kPlane);
  FacadeSite site = test::scan_wall(wall, eye, step);
  site.parallel.push_back({kPlane, 100});
  const RaySamples samples(site);
  const std::vector<std::uint32_t> planes{kPlane};
  const SideSearch search{
      {kLeft - 0.01, kRight + 0.01, kBottom, kTop}, kOut, 0.005, false, 0.01, kOut - 0.01, 0.06, planes};
  return locate_edge(samples, search, side);
}

// The rays that meet the end of a sill cross its front's plane beyond it, here by twice as much as they go in: a step
// of the scan is 4 cm along the wall, and the ends are known much better.
TEST(LocatedEdge, AnEndThatRaysMetIsWhereTheyMetIt) {
  for (const double eye : {-2.0, -3.0, -3.5, -4.2}) {
    const LocatedEdge end = end_of_sill({eye, 1.65, 2.5}, 0.0017, Side::left);
    EXPECT_EQ(end.status, DrawnStatus::seen);
    EXPECT_NEAR(end.at, kLeft, 0.003) << eye;
    EXPECT_NEAR(end.at, kLeft, end.error) << eye;
  }
}

// From before the sill its ends are not seen: they lie in a gap between two rays, and the error says so.
TEST(LocatedEdge, AnEndThatNobodySawLiesInItsGap) {
  for (const Side side : {Side::left, Side::right})
    for (const double eye : {3.4, 3.5, 3.6}) {
      const LocatedEdge end = end_of_sill({eye, 1.65, 6}, 0.003, side);
      EXPECT_NEAR(end.at, side == Side::left ? kLeft : kRight, end.error) << eye;
      EXPECT_GT(end.error, 0.003) << eye;
    }
}

// Nothing of the wall is near the place where the side is expected, but a bar is in the opening. The search that grows
// looks for the wall alone: where that is too far off the side stays unknown, and is not the bar.
TEST(LocatedEdge, ABarFartherInIsNotTheWall) {
  ScannedWall wall;
  wall.wall({{2, 0, 2, 3.1, 1, 2.6, 0}});
  wall.sheets.push_back({2, 0, 2.78, 2.84, 1, 2.6, 1});
  const FacadeSite site = test::scan_wall(wall, {5, 1.5, 8}, 0.002);
  const RaySamples samples(site);
  const SideSearch search{{2, 2.94, 1, 2.6}, 0, site.epsilon, true, -0.28, -0.015, 0.06, {}};
  const LocatedEdge jamb = locate_edge(samples, search, Side::right);
  EXPECT_NE(jamb.status, DrawnStatus::seen);
  EXPECT_GT(jamb.at, 2.9);
}

// Nobody knows where points were seen from: what lies right behind a thing, its own soffit and walls farther in, was
// seen another way than square to it.
TEST(LocatedEdge, PointsBehindAnElementGiveNoEdge) {
  test::SampledSite s(6, 4, 0.03, 0.002);
  s.sheet(1, 5, 1, 3, 1, kPlane);
  s.sheet(1, 5, 0.5, 3, -1, 7);  // a wall farther in: as many points, higher up too
  for (const double v : {1.0, 3.0}) s.face({1, v, 0}, {4, 0, 0}, {0, 0, 1}, 8);  // soffit and top
  const RaySamples samples(s.site);
  const std::vector<std::uint32_t> planes{kPlane};
  const SideSearch search{{1.02, 4.98, 1.02, 2.98}, 1, 0.007, false, 0.01, 0.99, 0.12, planes};
  for (const auto& [side, at] : {std::pair{Side::bottom, 1.0}, std::pair{Side::top, 3.0}}) {
    const LocatedEdge edge = locate_edge(samples, search, side);
    EXPECT_NEAR(edge.at, at, 0.004);
    EXPECT_NEAR(edge.at, at, edge.error);
    EXPECT_TRUE(edge.by_face);
  }
}

TEST(FaceCluster, AFewPointsThatAgreeAreAFaceScatteredOnesAreNone) {
  const FaceSearch search{0, 0.1, 0.008, 0.06, 0.1};
  std::vector<FacePoint> points{{0.051, 0.05, 0.01}, {0.049, 0.05, 0.04}, {0.050, 0.05, 0.06}, {0.050, 0.05, 0.09}};
  const FaceLine face = find_touches(densest_cluster(points, search), search, 0.001);
  EXPECT_EQ(face.points, 4u);
  EXPECT_NEAR(face.at, 0.05, 1e-12);
  EXPECT_NEAR(face.rms * face.error_factor, 0.0005, 1e-12);
  EXPECT_EQ(find_face(densest_cluster(points, search), search, 0).points, 0u);  // too few for a line
  points.insert(points.end(), {{0.02, 0.03, 0.01}, {0.08, 0.03, 0.05}});
  EXPECT_EQ(find_touches(densest_cluster(points, search), search, 0.001).points, 0u);
  points.resize(3);
  EXPECT_EQ(find_touches(densest_cluster(points, search), search, 0.001).points, 0u);
}

// A line is extended to the plane: the farther from its points, the less is known.
TEST(FaceCluster, ALineIsKnownLessFarFromItsPoints) {
  const FaceSearch search{0, 0.1, 0.02, 0.06, 0.1};
  std::vector<FacePoint> points;
  for (int i = 0; i < 20; ++i) points.push_back({0.05 + 0.001 * (i % 2), 0.01 + 0.002 * i, 0.005 * i});
  const FaceCluster cluster = densest_cluster(points, search);
  const FaceLine near = find_face(cluster, search, 0.03), far = find_face(cluster, search, 0.2);
  ASSERT_EQ(near.points, 20u);
  EXPECT_NEAR(near.error_factor, 1 / std::sqrt(20.0), 0.01);
  EXPECT_GT(far.error_factor, 4 * near.error_factor);
}

}  // namespace
}  // namespace ilot
