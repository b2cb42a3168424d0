// SPDX-License-Identifier: Apache-2.0
#include "engine/store/partition.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "engine/error.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using test::CloudStore;

constexpr std::int64_t kMost = INT64_MAX, kLeast = INT64_MIN;

IndexBox bounds(std::span<const Index3> points) {
  IndexBox box{{kMost, kMost, kMost}, {kLeast, kLeast, kLeast}};
  for (const Index3& p : points) {
    box.add(p);
  }
  return box;
}

void expect_chunk_boxes(const Store& store, std::uint32_t b, std::span<const Index3> points) {
  const auto chunks = store.read(b, columns::kChunks);
  ASSERT_EQ(chunks.size(), (points.size() + kChunkPoints - 1) / kChunkPoints);
  const Index3 c = corner(store.blocks()[b].node.tile);
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const std::size_t first = i * kChunkPoints;
    const IndexBox wanted = bounds(points.subspan(first, std::min<std::size_t>(kChunkPoints, points.size() - first)));
    const auto& [min, max] = chunks[i];
    EXPECT_EQ((IndexBox{{c.x + min[0], c.y + min[1], c.z + min[2]}, {c.x + max[0], c.y + max[1], c.z + max[2]}}),
              wanted);
  }
}

void expect_block(const Store& store, std::uint32_t b, std::uint64_t block_points) {
  const Block& block = store.blocks()[b];
  const auto codes = store.read(b, columns::kCodes);
  EXPECT_EQ(store.open(b, columns::kCodes).size(), block.points);
  EXPECT_TRUE(std::is_sorted(codes.begin(), codes.end()));
  EXPECT_TRUE(block.points <= block_points || codes.front() == codes.back()) << "only points in one place may be more";
  std::vector<Index3> points;
  for (const std::uint64_t code : codes) points.push_back(index_of({block.node.tile, code}));
  for (const Index3& p : points) ASSERT_TRUE(block.node.box().contains(p));
  EXPECT_EQ(block.box, bounds(points));
  expect_chunk_boxes(store, b, points);
}

class PartitionOf : public testing::TestWithParam<std::tuple<std::uint64_t, std::uint64_t, std::size_t>> {};

TEST_P(PartitionOf, EveryInputPointOnceInGlobalOrderWhateverTheBlocks) {
  const auto [block_points, run_points, files] = GetParam();
  const auto points = test::points_over_tiles(10000, 5);
  const CloudStore cloud(points, {block_points, run_points, files});
  const Store& store = cloud.store();
  ASSERT_EQ(store.points(), points.size());
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    expect_block(store, b, block_points);
    if (b == 0) continue;
    const Node &last = store.blocks()[b - 1].node, &node = store.blocks()[b].node;
    EXPECT_TRUE(before(last, node));
    EXPECT_TRUE(last.tile != node.tile || last.last_code() < node.first_code) << "blocks overlap";
  }
  EXPECT_EQ(test::positions(store), test::in_global_order(points));
  const auto order = test::whole_column(store, columns::kOrder);
  const auto where = test::positions(store);
  std::vector<bool> seen(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint64_t row = points.size() * file_of(order[i]) / files + row_of(order[i]);
    ASSERT_EQ(points[row], where[i]);
    ASSERT_FALSE(seen[row]);
    seen[row] = true;
    const bool tie = i > 0 && where[i - 1] == where[i];
    ASSERT_TRUE(!tie || order[i - 1] < order[i]) << "ties in input order";
  }
}

INSTANTIATE_TEST_SUITE_P(AnyCut, PartitionOf,
                         testing::Values(std::tuple{1u << 20, 1u << 20, 1}, std::tuple{1u << 20, 700, 3},
                                         std::tuple{4096, 2000, 1}, std::tuple{700, 1u << 20, 4},
                                         std::tuple{150, 3000, 2}));

TEST(Partition, PlansLeavesOfExactCountsDownToOnePoint) {
  const TemporaryFolder folder;
  const auto points = test::points_over_tiles(1500, 6);
  test::write_cloud(folder.path() / "c.las", points);
  const auto reader = open_cloud(folder.path() / "c.las");
  std::vector<SortedRun> runs;
  for (const std::uint64_t first : {0, 400, 800})
    runs.push_back(make_sorted_run({*reader, 0, first, first == 800 ? 700u : 400u}, test::kUnit, {},
                                   folder.path() / std::to_string(first), [](std::uint64_t) {}));
  std::map<PointKey, std::uint64_t> multiplicity;
  for (const Index3& p : points) ++multiplicity[key_of(p)];
  const auto plan = plan_blocks(runs, 1);
  ASSERT_EQ(plan.size(), multiplicity.size());
  std::size_t at = 0;
  for (const auto& [key, count] : multiplicity) {
    EXPECT_EQ(plan[at].points, count);
    EXPECT_TRUE(plan[at].node.box().contains(index_of(key)));
    std::uint64_t in_ranges = 0;
    for (const RunRange& r : plan[at].ranges) in_ranges += r.end - r.first;
    EXPECT_EQ(in_ranges, count);
    ++at;
  }
  EXPECT_TRUE(plan_blocks({}, 100).empty());
}

std::vector<SortedRun> runs_of(const TemporaryFolder& folder, const char* name, const std::vector<Index3>& points) {
  test::write_cloud(folder.path() / "c.las", points);
  const auto reader = open_cloud(folder.path() / "c.las");
  std::vector<SortedRun> runs;
  const std::uint64_t half = points.size() / 2;
  for (const std::uint64_t first : {std::uint64_t{0}, half})
    runs.push_back(make_sorted_run({*reader, 0, first, first == 0 ? half : points.size() - half}, test::kUnit, {},
                                   folder.path() / (name + std::to_string(first)), [](std::uint64_t) {}));
  return runs;
}

// Blocks are those of the points that stay, also where strays are in the same tile.
TEST(Partition, StraysAreInNoBlock) {
  const TemporaryFolder folder;
  auto points = test::points_over_tiles(5000, 8);
  const auto plain = plan_blocks(runs_of(folder, "plain", points), 300);
  constexpr int kFineBits = 16;
  const std::vector<Index3> strays{{70000, 70000, 1200000}, {70000, 70000, 1200000}, {1, 1, -1800000}, {1 << 29, 0, 0}};
  points.insert(points.begin() + 2000, strays.begin(), strays.end());
  std::vector<CoarseCell> cells;
  for (const Index3& p : strays) cells.push_back(coarse_cell(p, kFineBits));
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  const auto plan = plan_blocks(runs_of(folder, "strays", points), 300, Strays(kFineBits, cells));
  ASSERT_EQ(plan.size(), plain.size());
  for (std::size_t b = 0; b < plan.size(); ++b) {
    EXPECT_EQ(plan[b].node, plain[b].node);
    EXPECT_EQ(plan[b].points, plain[b].points);
  }
}

// However the points are spread: what the comment on kMostTiles says.
TEST(Partition, BlocksAreBounded) {
  const TemporaryFolder folder;
  for (const std::uint64_t block_points : {1u, 7u, 300u}) {
    const auto points = test::points_over_tiles(3000, block_points);
    std::set<Tile> tiles;
    for (const Index3& p : points) tiles.insert(key_of(p).tile);
    const auto plan = plan_blocks(runs_of(folder, "r", points), block_points);
    EXPECT_LE(plan.size(), tiles.size() + 147 * points.size() / block_points);
  }
  std::vector<Index3> wide;
  for (std::int64_t i = 0; i <= static_cast<std::int64_t>(kMostTiles); ++i)
    wide.push_back({(i % 500) << kTileBits, (i / 500) << kTileBits, 0});
  test::write_cloud(folder.path() / "wide.las", wide);
  const auto reader = open_cloud(folder.path() / "wide.las");
  EXPECT_THROW(make_sorted_run({*reader, 0, 0, wide.size()}, test::kUnit, {}, folder.path() / "all", [](auto) {}),
               Error)
      << "in one run";
  wide.pop_back();
  EXPECT_EQ(plan_blocks(runs_of(folder, "most", wide), 100).size(), kMostTiles);
  wide.push_back({-1, -1, -1});
  const auto runs = runs_of(folder, "more", wide);
  EXPECT_THROW(plan_blocks(runs, 100), Error) << "in all of them together";
}

}  // namespace
}  // namespace ilot
