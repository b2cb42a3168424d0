// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/ray_samples.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

FacadeSite site_with(std::vector<FacadePoint> points, std::vector<FacadeStation> stations) {
  FacadeSite site;
  site.width = 10;
  site.height = 5;
  site.points = std::move(points);
  site.stations = std::move(stations);
  return site;
}

TEST(RaySamples, RaysCrossTheWallOnTheirWay) {
  const FacadeSite site = site_with({{3, 2, -1, 0}, {3, 2, 0, 1}, {3, 2, 1, 0}}, {{{1, 1, 9}, 0.001, 0.002}});
  const RaySamples samples(site);
  EXPECT_NEAR(samples.crossing(0, 0).u, 1 + 2 * 0.9, 1e-6);
  EXPECT_NEAR(samples.crossing(0, 0).v, 1 + 0.9, 1e-6);
  EXPECT_NEAR(samples.crossing(0, 9).u, 1, 1e-6);
  EXPECT_EQ(samples.met(0, 0, 0.005), Met::through);
  EXPECT_EQ(samples.met(1, 0, 0.005), Met::solid);
  EXPECT_EQ(samples.met(2, 0, 0.005), Met::before);
  EXPECT_NEAR(samples.step_at({1, 1}).u, 0.009, 1e-12);
  EXPECT_NEAR(samples.step_at({1, 1}).v, 0.018, 1e-12);
}

TEST(RaySamples, WithoutStationsRaysAreSquareToTheWall) {
  const FacadeSite site = site_with({{3, 2, -1, 0}}, {});
  const RaySamples samples(site);
  EXPECT_EQ(samples.crossing(0, 0).u, 3);
  EXPECT_EQ(samples.step_at({1, 1}).u, site.step);
}

TEST(RaySamples, NearFindsAllOfABox) {
  std::vector<FacadePoint> points;
  Rng rng(2);
  for (int i = 0; i < 3000; ++i)
    points.push_back({static_cast<float>(12 * rng.uniform() - 1), static_cast<float>(7 * rng.uniform() - 1),
                      static_cast<float>(rng.uniform() - 0.5), 0});
  const FacadeSite site = site_with(points, {{{1, 1, 9}, 0.001, 0.002}});
  const RaySamples samples(site);
  const Box2 box{2.3, 3.9, -0.4, 1.7};
  const NearPoints near = samples.near(box);
  const std::vector<std::uint32_t> found(near.begin(), near.end());
  const std::set<std::uint32_t> set(found.begin(), found.end());
  EXPECT_EQ(set.size(), found.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    EXPECT_TRUE(!box.holds(samples.crossing(i, 0)) || set.count(i) > 0) << i;
}

TEST(RaySamples, NearOfBinsWithoutPointsIsEmpty) {
  const FacadeSite site = site_with({{9.5F, 4.5F, 0, 0}}, {});
  const RaySamples samples(site);
  const NearPoints none = samples.near({1, 2, 1, 2}), one = samples.near({9.4, 9.6, 0, 4.6});
  EXPECT_EQ(std::distance(none.begin(), none.end()), 0);
  EXPECT_EQ(std::vector<std::uint32_t>(one.begin(), one.end()), std::vector<std::uint32_t>{0});
}

// A pane seen from the left through its window: from the right the ray would have to go through the wall, or through
// the back of a joint between its stones.
TEST(RaySamples, OfSeveralStationsOneThatCouldSeeThePoint) {
  for (const float joint : {0.0f, 0.02f}) {
    std::vector<FacadePoint> points;
    for (int i = 0; i <= 250; ++i)
      for (int k = 0; k <= 250; ++k) {
        const float u = 0.04f * static_cast<float>(i), v = 0.02f * static_cast<float>(k);
        const bool deep = k >= 96 && k <= 100;
        if (u < 4 || u > 5 || v < 1 || v > 3) points.push_back({u, v, deep ? -joint : 0.0f, deep ? 0u : 1u});
      }
    const auto pane = static_cast<std::uint32_t>(points.size());
    points.push_back({4.95f, 2, -0.5f, 0});
    FacadeSite site = site_with(points, {{{9, 1.5, 4}, 0, 0}, {{1, 1.5, 8}, 0, 0}});
    site.step = 0.03;
    const RaySamples samples(site);
    EXPECT_LT(samples.crossing(pane, 0).u, 4.95) << joint;  // from the left, though the other stands nearer
  }
}

// What the file says of a point's station outweighs what could be guessed.
TEST(RaySamples, APointsOwnStation) {
  FacadeSite site =
      site_with({{3, 2, -1, 0}, {3, 2, -1, 0}, {3, 2, 0.5f, 0}, {3, 2, -1, 0}}, {{{1, 1, 9}, 0, 0}, {{5, 1, 3}, 0, 0}});
  site.from = {1, 2, kStationAside, kStationUnknown};
  const RaySamples samples(site);
  EXPECT_NEAR(samples.crossing(0, 0).u, 3 - 2 * 0.1, 1e-6);
  EXPECT_NEAR(samples.crossing(1, 0).u, 3 + 2 * 0.25, 1e-6);
  EXPECT_EQ(samples.crossing(2, 0).u, 3);
  EXPECT_EQ(samples.crossing(3, 0).u, samples.crossing(1, 0).u) << "the nearer one";
  EXPECT_TRUE(samples.guessed());
  site.from[3] = 1;
  EXPECT_FALSE(RaySamples(site).guessed());
  site.from.clear();
  EXPECT_TRUE(RaySamples(site).guessed());
}

// More stations than a byte counts, as a long street has.
TEST(RaySamples, StationsBeyondTwoHundredFiftyFour) {
  std::vector<FacadeStation> stations(400, {{50, 1, 30}, 0, 0});
  stations[299] = {{1, 1, 9}, 0, 0};
  FacadeSite site = site_with({{3, 2, -1, 0}}, stations);
  site.from = {300};
  EXPECT_NEAR(RaySamples(site).crossing(0, 0).u, 3 - 2 * 0.1, 1e-6);
  EXPECT_FALSE(RaySamples(site).guessed());
  site.from.clear();
  EXPECT_NEAR(RaySamples(site).crossing(0, 0).u, 3 - 2 * 0.1, 1e-6) << "the nearest of all";
}

}  // namespace
}  // namespace ilot
