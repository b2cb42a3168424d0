// SPDX-License-Identifier: Apache-2.0
#include "ilot/plane_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ilot/error.h"

namespace ilot {
namespace {

struct SearchedPoints {
  std::vector<double> x, y, z;
  PointArrays view() const { return {x, y, z}; }
};

// A gable roof of 12 m x 10 m at national coordinates, with noise of some millimetres; odd decimals.
SearchedPoints gable() {
  SearchedPoints p;
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 100; ++j) {
      const double x = 0.1003 * i, y = 0.0997 * j;
      p.x.push_back(652000.00037 + x);
      p.y.push_back(6862000.00061 + y);
      p.z.push_back(50 - 0.7 * std::abs(y - 5) + 0.005 * std::sin(1e4 * x + 3e4 * y));
    }
  return p;
}

double farthest(const SearchedPoints& p, const PlaneSegments& s) {
  double most = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i)
    if (s.label[i] > 0)
      most = std::max(most, std::abs(signed_distance(s.planes[s.label[i] - 1], {p.x[i], p.y[i], p.z[i]})));
  return most;
}

TEST(PublicPlanes, OfAGable) {
  const SearchedPoints p = gable();
  const PlaneSearchResult r = find_planes(p.view(), {.epsilon = 0.02, .min_points = 100});
  ASSERT_EQ(r.segments.planes.size(), 2u);
  for (const Plane& plane : r.segments.planes) {
    EXPECT_NEAR(std::abs(plane.n.y / plane.n.z), 0.7, 0.005);
    EXPECT_NEAR(plane.n.x, 0, 0.005);
  }
  EXPECT_LE(farthest(p, r.segments), 0.02);
  const auto labelled = std::count_if(r.segments.label.begin(), r.segments.label.end(), [](auto l) { return l > 0; });
  EXPECT_GT(labelled, 11500);
}

// With a lattice that is coarse beside epsilon, points as given still lie within it.
TEST(PublicPlanes, EpsilonHoldsForThePointsAsGiven) {
  const SearchedPoints p = gable();
  const PlaneSearchResult r = find_planes(p.view(), {.epsilon = 0.02, .min_points = 100, .step = 0.005});
  EXPECT_EQ(r.step, 0.005);
  EXPECT_FALSE(r.segments.planes.empty());
  EXPECT_LE(farthest(p, r.segments), 0.02);
  EXPECT_THROW(find_planes(p.view(), {.epsilon = 0.02, .step = 0.01}), Error);
}

TEST(PublicPlanes, DoNotDependOnOrderOrThreads) {
  const SearchedPoints p = gable();
  SearchedPoints backwards = p;
  for (auto* v : {&backwards.x, &backwards.y, &backwards.z}) std::reverse(v->begin(), v->end());
  const PlaneSearchResult a = find_planes(p.view(), {.threads = 1});
  const PlaneSearchResult b = find_planes(p.view(), {.threads = 2});
  const PlaneSearchResult c = find_planes(backwards.view());
  EXPECT_EQ(a.segments.label, b.segments.label);
  EXPECT_EQ(a.epsilon, c.epsilon);
  ASSERT_EQ(a.segments.planes.size(), c.segments.planes.size());
  for (std::size_t i = 0; i < p.x.size(); ++i)
    EXPECT_EQ(a.segments.label[i] == 0, c.segments.label[p.x.size() - 1 - i] == 0) << i;
}

TEST(PublicPlanes, RefuseOptionsOutOfRange) {
  const SearchedPoints p = gable();
  EXPECT_THROW(find_planes(p.view(), {.epsilon = 0}), Error);
  EXPECT_THROW(find_planes(p.view(), {.normal_angle_deg = 91}), Error);
  EXPECT_THROW(find_planes(p.view(), {.min_points = 2}), Error);
  EXPECT_THROW(find_planes(p.view(), {.connectivity = -1}), Error);
  EXPECT_THROW(find_planes(p.view(), {.probability = 1}), Error);
  EXPECT_THROW(find_planes(p.view(), {.normal_neighbours = 2}), Error);
  EXPECT_THROW(find_planes({std::span(p.x).first(5), std::span(p.y).first(5), std::span(p.z).first(5)}), Error);
}

}  // namespace
}  // namespace ilot
