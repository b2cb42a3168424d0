// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/hough_planes.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

HoughPlanesParams hough_params(double epsilon) {
  HoughPlanesParams p;
  p.epsilon = epsilon;
  p.distance_step = 2 * epsilon;
  p.connectivity = 60;
  p.min_points = 200;
  return p;
}

// Every cell has the same share of the half sphere, so any cap holds its share of the centres.
TEST(HoughPlanes, DirectionsHaveEqualSolidAngles) {
  const auto directions = equal_angle_directions(3);
  EXPECT_NEAR(static_cast<double>(directions.size()), 2 * 3.141592653589793 / std::pow(3 * 0.017453292519943295, 2),
              60);
  for (const Vec3& d : directions) {
    EXPECT_NEAR(norm(d), 1, 1e-12);
    EXPECT_GE(d.z, 0);
  }
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 v{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
    std::size_t inside = 0;
    for (const Vec3& d : directions) inside += std::abs(dot(d, v)) >= 0.9 * norm(v);  // a cap and its mirror: 0.1
    EXPECT_NEAR(static_cast<double>(inside) / static_cast<double>(directions.size()), 0.1, 0.01);
  }
}

TEST(HoughPlanes, TinyExactCase) {
  std::vector<Cell3> cells;
  for (std::uint32_t i = 0; i < 25; ++i) cells.push_back({i % 5 * 10, i / 5 * 10, 40});
  cells.push_back({20, 20, 90});
  const auto set = test::make_set("flat", cells);
  HoughPlanesParams params = hough_params(1);
  params.min_points = 20;
  const auto s = hough_planes({set.view()}, params);
  ASSERT_EQ(s.planes.size(), 1u);
  EXPECT_NEAR(s.planes[0].d, -40, 1e-9);
  for (std::size_t i = 0; i < set.size; ++i) EXPECT_EQ(s.label[i], set.z[i] == 40 ? 1u : 0u);
}

TEST(HoughPlanes, TheFacesOfABoxWithAndWithoutNormals) {
  const auto set = test::box_corner(2);
  for (const double vote : {0.0, 0.98}) {
    HoughPlanesParams params = hough_params(12);
    params.min_vote_cos = vote;
    params.min_cos = vote > 0 ? 0.9 : 0;
    const auto s = hough_planes(vote > 0 ? set.view() : OrientedPoints{set.view().points}, params);
    test::expect_sound(set, s, 12, 200);
    ASSERT_EQ(s.planes.size(), 3u) << vote;
    const auto count = test::label_sizes(s);
    EXPECT_GT(count[1], 2900u);
    EXPECT_GT(count[1] + count[2] + count[3], 7200u);
    EXPECT_GT(std::abs(s.planes[0].n.z), 0.9999);
  }
}

TEST(HoughPlanes, AnyOrderOfPointsGivesThePlanes) {
  const auto set = test::box_corner(3);
  const auto mixed = test::shuffled(set, 4);
  HoughPlanesParams params = hough_params(12);
  params.min_vote_cos = 0.98;
  const auto a = hough_planes(set.view(), params), b = hough_planes(mixed.set.view(), params);
  EXPECT_EQ(a.label, test::in_original_order(mixed, b.label));
}

TEST(HoughPlanes, DegenerateInputHasNoPlanes) {
  EXPECT_TRUE(hough_planes({}, hough_params(1)).planes.empty());
  const auto line = test::point_sets(300)[3];
  EXPECT_TRUE(hough_planes({line.view()}, hough_params(1)).planes.empty());
  const auto place = test::make_set("place", std::vector<Cell3>(300, {5, 5, 5}));
  EXPECT_TRUE(hough_planes({place.view()}, hough_params(1)).planes.empty());
}

}  // namespace
}  // namespace ilot
