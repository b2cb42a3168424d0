// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/clusters_pass.h"

#include <gtest/gtest.h>

#include <map>

#include "kernels/core/union_find.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

// Points around the corner of eight tiles in clumps; every third is not to be clustered.
std::vector<Index3> clumps(std::uint64_t key) {
  Rng rng(key);
  const auto within = [&](std::int64_t reach) {
    return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(2 * reach))) - reach;
  };
  std::vector<Index3> points;
  for (int c = 0; c < 60; ++c) {
    const Index3 centre{within(20000), within(20000), within(9000)};
    for (int i = 0; i < 60; ++i)
      points.push_back({centre.x + within(900), centre.y + within(900), centre.z + within(3000)});
  }
  return points;
}

constexpr PointRole kChosen{4};

void mark(const Store& store) {
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    std::vector<PointRole> role;
    for (const InputOrder order : store.read(b, columns::kOrder))
      role.push_back(row_of(order) % 3 == 0 ? PointRole{9} : kChosen);
    store.write(b, columns::kRole, role);
  }
}

// Oracle: all pairs.
std::vector<std::uint32_t> brute_force(const std::vector<Index3>& points, const std::vector<PointRole>& role,
                                       std::int64_t radius) {
  std::vector<std::uint32_t> parent(points.size());
  UnionFind sets(parent);
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j) {
      const std::int64_t dx = points[i].x - points[j].x, dy = points[i].y - points[j].y;
      if (role[i] == kChosen && role[j] == kChosen && dx * dx + dy * dy <= radius * radius) sets.unite(i, j);
    }
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::uint32_t> id(points.size(), 0);
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (role[i] == kChosen)
      id[i] = number.emplace(sets.find(i), static_cast<std::uint32_t>(number.size()) + 1).first->second;
  return id;
}

TEST(ClustersPass, IsThatOfAllPointsWhateverTheBlocks) {
  constexpr std::int64_t kRadius = 700;
  const auto points = clumps(5);
  for (const std::uint64_t block_points : {64u, 500u, 1u << 20}) {
    const test::CloudStore cloud(points, {block_points, 1u << 20, 1});
    const Store& store = cloud.store();
    mark(store);
    const auto clusters = clusters_pass(store, {kChosen, kRadius}, {});
    const auto positions = test::positions(store);
    const auto column = test::whole_column(store, columns::kCluster);
    EXPECT_EQ(column, brute_force(positions, test::whole_column(store, columns::kRole), kRadius));
    ASSERT_GT(clusters.size(), 3u);
    std::vector<std::uint64_t> counts(clusters.size());
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (column[i] == 0) continue;
      const CloudCluster& c = clusters[column[i] - 1];
      if (counts[column[i] - 1]++ == 0) {
        EXPECT_EQ(c.first, positions[i]);
      }
      EXPECT_TRUE(c.box.contains(positions[i]));
    }
    for (std::size_t c = 0; c < clusters.size(); ++c) EXPECT_EQ(counts[c], clusters[c].points);
  }
}

}  // namespace
}  // namespace ilot
