// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/normals_pass.h"
#include "kernels/geometry/padded_points.h"

#include <gtest/gtest.h>

#include <numeric>

#include "kernels/neighbours/normals.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using test::CloudStore;

// Dense patches, a sparse surface, lonely points and pairs at distances between: every reach from a few units to beyond
// the maximum radius, across tile borders.
std::vector<Index3> clustered_cloud(std::uint64_t key) {
  Rng rng(key);
  const auto draw = [&](std::int64_t bound) {
    return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(bound)));
  };
  std::vector<Index3> points;
  for (int patch = 0; patch < 6; ++patch) {
    const Index3 at{draw(40000) - 20000, draw(40000) - 20000, draw(3000) - 1500};
    for (int i = 0; i < 250; ++i) {
      const std::int64_t u = draw(400), v = draw(400);
      points.push_back({at.x + u, at.y + v, at.z + u / 3 + draw(5)});
    }
  }
  for (int i = 0; i < 400; ++i) points.push_back({draw(60000) - 30000, draw(60000) - 30000, draw(100)});
  for (int i = 0; i < 40; ++i) points.push_back({draw(200000) - 100000, draw(200000) - 100000, draw(90000) - 45000});
  for (int i = 0; i < 60; ++i) points.push_back({777, -777, 5000});
  return points;
}

// Oracle: one kNN over all points, no blocks.
std::vector<PackedNormal> over_all(const std::vector<Index3>& sorted, int k, std::int64_t radius) {
  PaddedPoints all;
  for (const Index3& p : sorted) all.add(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  all.pad();
  std::vector<std::uint32_t> queries(sorted.size());
  std::iota(queries.begin(), queries.end(), 0u);
  std::vector<PackedNormal> out(sorted.size());
  std::vector<std::int64_t> reach2(sorted.size());
  const NeighbourIndex index = build_neighbour_index(all.points());
  normals(index, queries, {k, radius * radius}, out, reach2);
  return out;
}

struct Case {
  int k;
  double max_radius;  // metres
  std::uint64_t task_points;
};

class NormalsPassOf : public testing::TestWithParam<std::uint64_t> {};

TEST_P(NormalsPassOf, EqualsOneSearchOverAllPoints) {
  const auto points = clustered_cloud(1);
  const auto sorted = test::in_global_order(points);
  for (const Case c : {Case{16, 10, 1u << 21}, Case{4, 2.5, 1}, Case{64, 1000, 900}}) {
    const CloudStore cloud(points, {GetParam(), 1u << 20, 1});
    PassContext context;
    context.task_points = c.task_points;
    normals_pass(cloud.store(), {c.k, c.max_radius, false}, context);
    const auto got = test::whole_column(cloud.store(), columns::kNormals);
    const auto wanted = over_all(sorted, c.k, static_cast<std::int64_t>(c.max_radius * 1000));
    ASSERT_EQ(got.size(), wanted.size());
    std::size_t wrong = 0, none = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      wrong += !(got[i] == wanted[i]);
      none += wanted[i] == PackedNormal{};
    }
    EXPECT_EQ(wrong, 0u) << "k " << c.k << " radius " << c.max_radius << " task_points " << c.task_points;
    EXPECT_LT(none, got.size() / 4) << "the oracle has little to say";
  }
}

INSTANTIATE_TEST_SUITE_P(AnyBlocks, NormalsPassOf, testing::Values(64, 500, 1000000));

TEST(NormalsPass, KeepsWhatAnEarlierRunWroteAndCountsEveryPoint) {
  const CloudStore cloud(clustered_cloud(2), {500, 1u << 20, 1});
  std::atomic<std::uint64_t> reported{0};
  PassContext context;
  context.advance = [&](std::uint64_t n) { reported += n; };
  const std::vector<PackedNormal> mark(cloud.store().blocks()[1].points, PackedNormal{1, 2, 3, 4});
  cloud.store().write(1, columns::kNormals, mark);
  normals_pass(cloud.store(), {}, context);
  EXPECT_EQ(reported, cloud.store().points());
  EXPECT_EQ(cloud.store().read(1, columns::kNormals), mark);
}

TEST(NormalsPass, ThePointsOfTwoAndOfOne) {
  for (const std::vector<Index3>& points :
       {std::vector<Index3>{{5, 5, 5}}, std::vector<Index3>{{0, 0, 0}, {-1, -1, -1}}}) {
    const CloudStore cloud(points);
    normals_pass(cloud.store(), {}, {});
    for (const PackedNormal& n : test::whole_column(cloud.store(), columns::kNormals)) EXPECT_EQ(n, PackedNormal{});
  }
}

}  // namespace
}  // namespace ilot
