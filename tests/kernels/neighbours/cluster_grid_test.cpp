// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/cluster_grid.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/core/rng.h"
#include "tests/support/point_sets.h"

namespace ilot {
namespace {

// Points in a box, on a sheet through it, and many times in one place.
std::vector<Cell3> scattered(std::size_t count, std::uint32_t extent, Rng& rng) {
  const auto any = [&] { return static_cast<std::uint32_t>(rng.below(extent)); };
  std::vector<Cell3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t x = any(), y = any();
    points.push_back(i % 3 == 0 ? Cell3{x, y, any()} : i % 3 == 1 ? Cell3{x, y, (x + y) / 2} : Cell3{7, 7, 7});
  }
  return points;
}

void expect_same(const Clusters& got, const Clusters& wanted) {
  EXPECT_EQ(got.count, wanted.count);
  EXPECT_EQ(got.id, wanted.id);
}

std::vector<std::uint32_t> some_of(std::size_t count, std::uint64_t of, Rng& rng) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < count; ++i)
    if (rng.below(of) == 0) chosen.push_back(i);
  return chosen;
}

TEST(ClusterGrid, TheSameAsClustersOfEachSubset) {
  Rng rng(28);
  ClusterScratch scratch;
  for (const std::uint32_t extent : {20u, 300u, 5000u})
    for (const std::int64_t radius : {1, 2, 5, 40, 300}) {
      const auto set = test::make_set("scattered", scattered(1500, extent, rng));
      const ClusterGrid grid = build_cluster_grid(set.view(), radius);
      ASSERT_FALSE(grid.empty());
      for (const std::uint64_t of : {1u, 2u, 7u, 100u}) {
        const auto chosen = some_of(set.size, of, rng);
        expect_same(grid_clusters(grid, set.view(), chosen, scratch), euclidean_clusters(set.view(), chosen, radius));
      }
      EXPECT_EQ(grid_clusters(grid, set.view(), {}, scratch).count, 0u);
    }
}

// The grid of two of three points, in another order.
TEST(ClusterGrid, TheGridOfASubsetIsAsGood) {
  Rng rng(29);
  const auto set = test::make_set("scattered", scattered(3000, 400, rng));
  const ClusterGrid grid = build_cluster_grid(set.view(), 12);
  PaddedPoints left;
  std::vector<std::uint32_t> bins;
  for (std::size_t i = set.size; i-- > 0;)
    if (i % 3 != 1) {
      left.add(set.x[i], set.y[i], set.z[i]);
      bins.push_back(grid.bin[i]);
    }
  left.pad();
  const ClusterGrid narrow = subset_grid(grid, bins);
  EXPECT_LT(narrow.near_of.size(), grid.near_of.size());
  ClusterScratch scratch;
  for (const std::uint64_t of : {1u, 4u, 30u}) {
    const auto chosen = some_of(left.size, of, rng);
    expect_same(grid_clusters(narrow, left.points(), chosen, scratch), euclidean_clusters(left.points(), chosen, 12));
  }
}

// A lattice with a point in each bin: most have 58 bins ahead. With eight points in a place they are few for a point.
TEST(ClusterGrid, EmptyWhereTooManyBinsAreNearForThePoints) {
  constexpr std::int64_t kRadius = 300;
  const auto step = static_cast<std::uint32_t>(bin_edge(kRadius));
  for (const std::size_t times : {1u, 8u}) {
    std::vector<Cell3> points;
    for (std::uint32_t i = 0; i < 1728; ++i)
      points.insert(points.end(), times, Cell3{i % 12 * step, i / 12 % 12 * step, i / 144 * step});
    const auto set = test::make_set("lattice", points);
    const ClusterGrid grid = build_cluster_grid(set.view(), kRadius);
    EXPECT_EQ(grid.empty(), times == 1);
    EXPECT_LE(grid.near.size(), 8 * set.size);
  }
}

TEST(ClusterGrid, EmptyWithoutPointsAndWhereTheRadiusIsTooSmall) {
  EXPECT_TRUE(build_cluster_grid({}, 5).empty());
  PaddedPoints set;
  set.add(0, 0, 0);
  set.add(0x1p23f, 0, 0);
  set.pad();
  EXPECT_TRUE(build_cluster_grid(set.points(), 1).empty());
  EXPECT_FALSE(build_cluster_grid(set.points(), 32).empty());
}

}  // namespace
}  // namespace ilot
