// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/ray_samples.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/facades/arched_top.h"
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

TEST(ArchedTop, RoundStaysRoundAndStraightStraight) {
  for (const bool round : {true, false}) {
    FacadeSite site = site_with({}, {{{1, 1.2, 8}, 0.002, 0.002}});
    Rng rng(6);
    const double radius = 0.6;
    for (double u = 2; u < 6; u += 0.016)
      for (double v = 0.5; v < 4.5; v += 0.016) {
        const double x = u + 0.002 * rng.uniform(), y = v + 0.002 * rng.uniform();
        const double off = std::sqrt((x - 4) * (x - 4) + (y - 2.5) * (y - 2.5));
        const bool hole = std::abs(x - 4) < radius && y > 1 && (y < 2.5 || (round ? off < radius : y < 3.1));
        // Rays through the hole end a quarter of a metre behind the wall.
        const double t = hole ? 8.25 / 8 : 1;
        site.points.push_back({static_cast<float>(1 + (x - 1) * t), static_cast<float>(1.2 + (y - 1.2) * t),
                               hole ? -0.25f : 0.0f, hole ? 0u : 1u});
      }
    site.step = 0.016;
    const auto openings = find_openings(RaySamples(site));
    ASSERT_EQ(openings.size(), 1u);
    EXPECT_EQ(openings[0].arc.has_value(), round);
    if (!round) continue;
    EXPECT_NEAR(openings[0].arc->radius, radius, 0.005);
    EXPECT_NEAR(openings[0].arc->centre.u, 4, 0.005);
    EXPECT_NEAR(openings[0].arc->centre.v, 2.5, 0.008);
  }
}

// A segmental arch whose surround hides the wall above it, in a wall with a joint that touches the crown.
TEST(ArchedTop, AFlatArchBelowASurroundAndBesideAJoint) {
  FacadeSite site = site_with({}, {{{1, 1.2, 8}, 0.002, 0.002}});
  site.step = 0.016;
  site.parallel = {{7, 1000}};
  const double radius = 1.2, rise = 0.18, springing = 2.9, centre = springing + rise - radius;
  const double half = std::sqrt(radius * radius - (radius - rise) * (radius - rise));
  Rng rng(4);
  for (double a = 2; a < 6; a += 0.008)
    for (double b = 0.5; b < 4.5; b += 0.008) {
      const double x = a + 0.002 * rng.uniform(), y = b + 0.002 * rng.uniform();  // where the ray crosses the wall
      const auto add = [&](double w, std::uint32_t plane) {
        const double t = (8 - w) / 8;
        site.points.push_back({static_cast<float>(1 + (x - 1) * t), static_cast<float>(1.2 + (y - 1.2) * t),
                               static_cast<float>(w), plane});
      };
      const auto hole = [&](double u, double v) {
        const double off = std::sqrt((u - 4) * (u - 4) + (v - centre) * (v - centre));
        return std::abs(u - 4) < half && v > 1 && (v < springing || off < radius);
      };
      const double front_u = 1 + (x - 1) * 7.94 / 8, front_v = 1.2 + (y - 1.2) * 7.94 / 8;
      const bool surround = std::abs(front_u - 4) < half + 0.1 && front_v > 2.5 && front_v < 3.3;
      if (surround && !hole(front_u, front_v))
        add(0.06, 0);
      else if (hole(x, y))
        add(-0.25, 0);
      else if (y > springing + rise - 0.02 && y < springing + rise + 0.015)
        add(-0.02, 7);
      else
        add(0, 1);
    }
  const auto openings = find_openings(RaySamples(site));
  ASSERT_EQ(openings.size(), 1u);
  ASSERT_TRUE(openings[0].arc.has_value());
  EXPECT_NEAR(openings[0].arc->radius, radius, 0.05);
  EXPECT_NEAR(openings[0].arc->centre.v + openings[0].arc->radius, springing + rise, 0.004);
}

}  // namespace
}  // namespace ilot
