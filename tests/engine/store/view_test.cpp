// SPDX-License-Identifier: Apache-2.0
#include "engine/store/view.h"

#include <gtest/gtest.h>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using test::CloudStore;

Index3 position(const View& v, std::size_t i) {
  return {static_cast<std::int64_t>(v.x[i]) + v.anchor.x, static_cast<std::int64_t>(v.y[i]) + v.anchor.y,
          static_cast<std::int64_t>(v.z[i]) + v.anchor.z};
}

void expect_aligned(const Store& store, const View& view) {
  std::size_t at = 0;
  for (std::size_t s = 0; s < view.slices.size(); ++s) {
    const Slice& slice = view.slices[s];
    EXPECT_EQ(slice.at, at);
    EXPECT_GT(slice.count, 0u);
    EXPECT_LE(slice.first + slice.count, store.blocks()[slice.block].points);
    at += slice.count;
    if (s == 0) continue;
    const Slice& last = view.slices[s - 1];
    EXPECT_TRUE(last.block < slice.block || (last.block == slice.block && last.first + last.count < slice.first));
  }
  EXPECT_EQ(at, view.size);
  ASSERT_GE(view.x.size(), view.size + 16);
}

TEST(View, EqualsTheFilterOfAllPointsForAnyBoxAndBlocks) {
  const auto points = test::points_over_tiles(15000, 1);
  for (const std::uint64_t block_points : {600u, 5000u, 1u << 20}) {
    const CloudStore cloud(points, {block_points, 1u << 20, 2});
    const Store& store = cloud.store();
    const auto all = test::positions(store);
    const auto order = test::whole_column(store, columns::kOrder);
    Rng rng(block_points);
    for (int round = 0; round < 40; ++round) {
      const Index3 centre = all[rng.below(all.size())];
      const auto reach = static_cast<std::int64_t>(rng.below(std::uint64_t{1} << rng.below(22)));
      const IndexBox box = IndexBox{centre, centre}.grown(reach);
      const View view = load_view(store, box, centre);
      expect_aligned(store, view);
      const auto view_order = load_column(store, view, columns::kOrder);
      std::vector<InputOrder> wanted, found;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (box.contains(all[i])) wanted.push_back(order[i]);
      for (std::size_t i = 0; i < view.size; ++i) {
        ASSERT_EQ(position(view, i), points[points.size() * file_of(view_order[i]) / 2 + row_of(view_order[i])]);
        if (box.contains(position(view, i))) found.push_back(view_order[i]);
      }
      ASSERT_EQ(found, wanted) << "block_points " << block_points << " reach " << reach;
    }
  }
}

TEST(View, ABoxWithoutPointsReadsNothing) {
  const CloudStore cloud(test::points_over_tiles(2000, 2));
  const View view = load_view(cloud.store(), {{9000000, 0, 0}, {9000001, 1, 1}}, {9000000, 0, 0});
  EXPECT_EQ(view.size, 0u);
  EXPECT_TRUE(view.slices.empty());
  EXPECT_EQ(range_of_block(view, 0).begin, range_of_block(view, 0).end);
  EXPECT_EQ(plan_view(cloud.store(), {{0, 0, 0}, {-1, -1, -1}}, {}).size, 0u) << "an empty box";
}

TEST(View, ReadsChunksNotBlocks) {
  std::vector<Index3> line;
  for (int i = 0; i < 20000; ++i) line.push_back({i * 10, 0, 0});
  const CloudStore cloud(line);
  const View view = plan_view(cloud.store(), {{50000, 0, 0}, {50010, 0, 0}}, {});
  EXPECT_GE(view.size, 2u);
  EXPECT_LE(view.size, 2u * kChunkPoints);
}

TEST(View, KnowsWhereABlockLies) {
  const CloudStore cloud(test::points_over_tiles(20000, 3), {1000, 1u << 20, 1});
  const Store& store = cloud.store();
  for (std::uint32_t b = 0; b < store.blocks().size(); b += 3) {
    const View view = load_view(store, store.blocks()[b].box.grown(50), store.blocks()[b].node.min_corner());
    const PointRange range = range_of_block(view, b);
    ASSERT_EQ(range.end - range.begin, store.blocks()[b].points);
    const auto codes = store.read(b, columns::kCodes);
    for (std::uint32_t i = range.begin; i < range.end; ++i)
      ASSERT_EQ(key_of(position(view, i)).code, codes[i - range.begin]);
  }
}

}  // namespace
}  // namespace ilot
