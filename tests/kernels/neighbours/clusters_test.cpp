// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/clusters.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "tests/support/point_sets.h"

namespace ilot {
namespace {

// Flood over all pairs.
Clusters brute_clusters(Points p, std::span<const std::uint32_t> indices, std::int64_t radius) {
  Clusters c{std::vector<std::uint32_t>(indices.size(), 0xffffffffu), 0};
  for (std::size_t seed = 0; seed < indices.size(); ++seed) {
    if (c.id[seed] != 0xffffffffu) continue;
    std::vector<std::size_t> stack{seed};
    c.id[seed] = c.count;
    while (!stack.empty()) {
      const std::uint32_t i = indices[stack.back()];
      stack.pop_back();
      for (std::size_t n = 0; n < indices.size(); ++n) {
        if (c.id[n] != 0xffffffffu) continue;
        const std::uint32_t j = indices[n];
        const double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j], dz = p.z[i] - p.z[j];
        if (dx * dx + dy * dy + dz * dz > static_cast<double>(radius * radius)) continue;
        c.id[n] = c.count;
        stack.push_back(n);
      }
    }
    ++c.count;
  }
  return c;
}

TEST(EuclideanClusters, RadiusIsClosed) {
  const auto set = test::make_set("three", {{0, 0, 0}, {5, 0, 0}, {11, 0, 0}});
  const std::uint32_t all[] = {0, 1, 2};
  EXPECT_EQ(euclidean_clusters(set.view(), all, 5).count, 2u);
  EXPECT_EQ(euclidean_clusters(set.view(), all, 6).count, 1u);
  EXPECT_EQ(euclidean_clusters(set.view(), all, 4).count, 3u);
  EXPECT_EQ(euclidean_clusters(set.view(), {}, 4).count, 0u);
}

// Two crowded bins, of which one pair of points at most is in reach.
TEST(EuclideanClusters, DenseBinsOneUnitOutOfReach) {
  constexpr std::int64_t kRadius = 900;
  for (const std::uint32_t gap : {900u, 901u}) {
    std::vector<Cell3> points{{101, 500, 100}, {101 + gap, 500, 100}};
    for (std::uint32_t i = 0; i < 400; ++i) {
      const std::uint32_t y = i % 20 * 10, z = i / 20 * 10;
      points.push_back({i * 37 % 101, y, z});
      points.push_back({102 + gap + i * 53 % 101, y, z});
    }
    const auto set = test::make_set("crowded", points);
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0u);
    const Clusters got = euclidean_clusters(set.view(), all, kRadius);
    EXPECT_EQ(got.count, gap == 900 ? 1u : 2u);
    EXPECT_EQ(got.id, brute_clusters(set.view(), all, kRadius).id);
  }
}

TEST(EuclideanClusters, EqualsBruteForce) {
  for (const std::uint32_t n : {1u, 2u, 9u, 119u, 122u, 300u}) {
    for (const auto& set : test::point_sets(n)) {
      std::vector<std::uint32_t> indices;
      for (std::uint32_t i = 0; i < n; ++i)
        if (i % 5 != 3) indices.push_back(i);
      for (const std::int64_t radius : {4, 12, 60, 900}) {
        const Clusters got = euclidean_clusters(set.view(), indices, radius);
        const Clusters want = brute_clusters(set.view(), indices, radius);
        EXPECT_EQ(got.count, want.count) << set.name << " r=" << radius;
        EXPECT_EQ(got.id, want.id) << set.name << " r=" << radius;
      }
    }
  }
}

}  // namespace
}  // namespace ilot
