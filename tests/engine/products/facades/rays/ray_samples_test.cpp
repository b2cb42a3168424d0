// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/ray_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "tests/support/facade_sites.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

FacadeSite site_with(std::vector<FacadePoint> points, std::vector<FacadeStation> stations) {
  FacadeSite site;
  site.width = 10;
  site.height = 5;
  site.points = std::move(points);
  for (std::size_t i = 0; i < site.points.size(); ++i) site.points[i].plane = static_cast<std::uint32_t>(i);
  site.stations = std::move(stations);
  return site;
}

// By the numbers that site_with gave them.
std::vector<Ray> in_order(Rays rays) {
  std::vector<Ray> found(rays.begin(), rays.end());
  std::sort(found.begin(), found.end(), [](const Ray& a, const Ray& b) { return a.at.plane < b.at.plane; });
  return found;
}

TEST(RaySamples, RaysCrossTheWallOnTheirWay) {
  const FacadeSite site = site_with({{3, 2, -1, 0}, {3, 2, 0, 1}, {3, 2, 1, 0}}, {{{1, 1, 9}, 0.001, 0.002}});
  const RaySamples samples(site);
  const std::vector<Ray> rays = in_order(samples.all());
  EXPECT_NEAR(samples.crossing(rays[0], 0).u, 1 + 2 * 0.9, 1e-6);
  EXPECT_NEAR(samples.crossing(rays[0], 0).v, 1 + 0.9, 1e-6);
  EXPECT_NEAR(samples.crossing(rays[0], 9).u, 1, 1e-6);
  EXPECT_EQ(samples.met(rays[0], 0, 0.005), RayOutcome::through);
  EXPECT_EQ(samples.met(rays[1], 0, 0.005), RayOutcome::solid);
  EXPECT_EQ(samples.met(rays[2], 0, 0.005), RayOutcome::before);
  EXPECT_NEAR(samples.step_at({1, 1}).u, 0.009, 1e-12);
  EXPECT_NEAR(samples.step_at({1, 1}).v, 0.018, 1e-12);
}

TEST(RaySamples, WithoutStationsRaysAreSquareToTheWall) {
  const FacadeSite site = site_with({{3, 2, -1, 0}}, {});
  const RaySamples samples(site);
  EXPECT_EQ(samples.crossing(in_order(samples.all())[0], 0).u, 3);
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
  const std::vector<Ray> near = in_order(samples.near(box)), there = in_order(samples.at_places(box));
  const auto contains = [](const std::vector<Ray>& rays, const Ray& ray) {
    return std::count_if(rays.begin(), rays.end(), [&](const Ray& r) { return r.at.plane == ray.at.plane; });
  };
  for (const Ray& ray : in_order(samples.all())) {
    EXPECT_TRUE(!box.contains(samples.crossing(ray, 0)) || contains(near, ray) == 1) << ray.at.plane;
    EXPECT_TRUE(!box.contains({ray.at.u, ray.at.v}) || contains(there, ray) == 1) << ray.at.plane;
  }
  EXPECT_LT(near.size(), 1000u);
  EXPECT_LT(there.size(), 1500u);
}

TEST(RaySamples, NearOfBinsWithoutPointsIsEmpty) {
  const FacadeSite site = site_with({{9.5F, 4.5F, 0, 0}}, {});
  const RaySamples samples(site);
  EXPECT_EQ(in_order(samples.near({1, 2, 1, 2})).size(), 0u);
  EXPECT_EQ(in_order(samples.near({9.4, 9.6, 0, 4.6})).size(), 1u);
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
    EXPECT_LT(samples.crossing(in_order(samples.all())[pane], 0).u, 4.95)
        << joint;  // from the left, though the other stands nearer
  }
}

// What the file says of a point's station outweighs what could be guessed.
TEST(RaySamples, APointsOwnStation) {
  FacadeSite site =
      site_with({{3, 2, -1, 0}, {3, 2, -1, 0}, {3, 2, 0.5f, 0}, {3, 2, -1, 0}}, {{{1, 1, 9}, 0, 0}, {{5, 1, 3}, 0, 0}});
  site.from = {1, 2, kStationNotInFront, kStationUnknown};
  const RaySamples samples(site);
  const std::vector<Ray> rays = in_order(samples.all());
  EXPECT_NEAR(samples.crossing(rays[0], 0).u, 3 - 2 * 0.1, 1e-6);
  EXPECT_NEAR(samples.crossing(rays[1], 0).u, 3 + 2 * 0.25, 1e-6);
  EXPECT_EQ(samples.crossing(rays[2], 0).u, 3);
  EXPECT_EQ(samples.crossing(rays[3], 0).u, samples.crossing(rays[1], 0).u) << "the nearer one";
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
  const auto crossing = [&] {
    const RaySamples samples(site);
    return samples.crossing(in_order(samples.all())[0], 0).u;
  };
  EXPECT_NEAR(crossing(), 3 - 2 * 0.1, 1e-6);
  EXPECT_FALSE(RaySamples(site).guessed());
  site.from.clear();
  EXPECT_NEAR(crossing(), 3 - 2 * 0.1, 1e-6) << "the nearest of all";
}

// A facade of 200,000 points from a source, in files and in pieces of any size, and the same one in memory.
TEST(RaySamples, FilesAndMemoryGiveTheSameOrder) {
  Rng rng(4);
  std::vector<FacadePoint> points;
  for (int i = 0; i < 200000; ++i)
    points.push_back({static_cast<float>(12 * rng.uniform() - 1), static_cast<float>(7 * rng.uniform() - 1),
                      static_cast<float>(rng.uniform() - 0.5), 0});
  for (int i = 0; i < 80000; ++i) points.push_back({2.01F, 2.02F, 0, 0});  // more in one place than are sorted together
  FacadeSite site = site_with(std::move(points), {{{1, 1, 9}, 0, 0}, {{5, 1, 3}, 0, 0}});
  for (FacadePoint& p : site.points) p.plane %= 7;
  site.wall = {1, 2};
  site.parallel = {{4, 1}, {6, 1}};
  FacadeSite bare = site;
  bare.points.clear();
  const TemporaryFolder folder;
  const FacadePointSource source = [&](const TakeFacadePoints& take) {
    const std::span<const FacadePoint> all(site.points);
    for (std::size_t first = 0; first < all.size(); first += 777)
      take(all.subspan(first, std::min<std::size_t>(777, all.size() - first)), {});
  };
  const RaySamples memory(site), files(bare, source, {folder.path()});
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  const auto same = [](Rays a, Rays b) {
    const std::vector<Ray> left(a.begin(), a.end()), right(b.begin(), b.end());
    ASSERT_EQ(left.size(), right.size());
    EXPECT_EQ(std::memcmp(left.data(), right.data(), left.size() * sizeof(Ray)), 0);
  };
  same(memory.all(), files.all());
  same(memory.near({2, 4, 1, 3}), files.near({2, 4, 1, 3}));
  same(memory.at_places({2, 4, 1, 3}), files.at_places({2, 4, 1, 3}));
  for (const std::uint32_t id : {1u, 2u, 4u, 6u}) {
    EXPECT_EQ(files.run_of(id).count, 40000u) << id;
    same(Rays(memory.by_segment(), {memory.run_of(id)}), Rays(files.by_segment(), {files.run_of(id)}));
  }
  EXPECT_EQ(files.run_of(3).count, 0u);
  EXPECT_EQ(memory.points_on_wall(), files.points_on_wall());
}

TEST(Rays, ThinnedByContent) {
  Rng rng(3);
  FacadeSite site;
  site.width = 10, site.height = 5;
  for (int i = 0; i < 100000; ++i)
    site.points.push_back({static_cast<float>(10 * rng.uniform()), static_cast<float>(5 * rng.uniform()), 0, 0});
  const auto kept = [](const RaySamples& samples, std::uint64_t most) {
    Rays rays = samples.all();
    const int level = thinning_level(rays, most, [](const Ray& ray) { return ray.at.u < 5; });
    std::vector<std::pair<float, float>> places;
    for (const Ray& ray : rays)
      if (ray.at.u < 5 && is_kept(ray, level)) places.emplace_back(ray.at.u, ray.at.v);
    std::sort(places.begin(), places.end());
    return places;
  };
  const auto before = kept(RaySamples(site), 10000);
  EXPECT_LE(before.size(), 10000u);
  EXPECT_GT(before.size(), 5000u);
  std::reverse(site.points.begin(), site.points.end());
  EXPECT_EQ(kept(RaySamples(site), 10000), before);
  EXPECT_GT(kept(RaySamples(site), 60000).size(), 40000u) << "no more than the limit are asked for: all stay";
}

}  // namespace
}  // namespace ilot
