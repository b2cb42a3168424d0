// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/cells.h"

#include <gtest/gtest.h>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using test::CloudStore;

// A metre per unit makes cells of 64 units, so that few points fill many of them.
constexpr double kMetre = 1000;

std::vector<Index3> spread(std::size_t n, std::uint64_t key) {
  Rng rng(key);
  const auto within = [&](std::uint64_t reach) {
    return static_cast<std::int64_t>(rng.below(2 * reach)) - static_cast<std::int64_t>(reach);
  };
  std::vector<Index3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({within(400), within(300), within(40)});
  return points;
}

void expect_partition(const Store& store, const std::vector<Cell>& cells) {
  std::vector<std::uint32_t> next(store.blocks().size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    std::uint64_t count = 0;
    for (const CellSlice& s : cells[c].slices) {
      EXPECT_EQ(s.first, next[s.block]) << "slices follow each other in their block";
      next[s.block] = s.first + s.count;
      count += s.count;
      for (const std::uint64_t code : store.read(s.block, columns::kCodes, s.first, s.count))
        ASSERT_TRUE(cells[c].node.box().contains(index_of({store.blocks()[s.block].node.tile, code})));
    }
    EXPECT_EQ(count, cells[c].points);
    EXPECT_GT(count, 0u);
    EXPECT_TRUE(c == 0 || before(cells[c - 1].node, cells[c].node));
  }
  for (std::uint32_t b = 0; b < next.size(); ++b) EXPECT_EQ(next[b], store.blocks()[b].points);
}

TEST(Cells, PartitionThePointsAndDoNotKnowTheBlocks) {
  const auto points = spread(20000, 1);
  std::vector<Node> wanted;
  for (const std::uint64_t block_points : {1u << 20, 3000u, 200u}) {
    const CloudStore cloud(points, {block_points, 1u << 20, 1});
    const auto cells = canonical_cells(cloud.store(), kMetre);
    expect_partition(cloud.store(), cells);
    std::vector<Node> nodes;
    for (const Cell& c : cells) {
      EXPECT_EQ(c.node.edge(), 64);
      nodes.push_back(c.node);
    }
    if (wanted.empty()) wanted = nodes;
    EXPECT_EQ(nodes, wanted) << block_points;
  }
  EXPECT_GT(wanted.size(), 100u);
}

// A normal that tells which point it belongs to.
PackedNormal normal_of(std::uint64_t code) {
  const std::uint64_t h = mix64(code);
  return {static_cast<std::int16_t>(h), static_cast<std::int16_t>(h >> 16), static_cast<std::int16_t>(h >> 32), 7};
}

void write_normals(const Store& store) {
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    std::vector<PackedNormal> normals;
    for (const std::uint64_t code : store.read(b, columns::kCodes)) normals.push_back(normal_of(code));
    store.write(b, columns::kNormals, normals);
  }
}

// A margin over a dense surface is thinned: its size is bounded, and what stays is a part of it.
TEST(Cells, DenseMarginsAreThinned) {
  std::vector<Index3> points{{0, 0, 100000}};
  for (int i = 0; i < 700; ++i)
    for (int j = 0; j < 700; ++j) points.push_back({20000 + 50 * i, 20000 + 50 * j, -1});
  const CloudStore cloud(points);
  write_normals(cloud.store());
  for (const Cell& cell : canonical_cells(cloud.store(), 1)) {
    const CellPoints cp = load_cell(cloud.store(), cell);
    EXPECT_LE(cp.size, 2 * kCellPoints + 4096);
  }
}

TEST(Cells, AreCutUntilTheyHoldFewEnough) {
  std::vector<Index3> points;
  for (int i = 0; i < 600; ++i)
    for (int j = 0; j < 600; ++j) points.push_back({i * 10, j * 10, 0});
  const CloudStore cloud(points, {1u << 16, 1u << 20, 1});
  const auto cells = canonical_cells(cloud.store(), 1);
  expect_partition(cloud.store(), cells);
  EXPECT_GT(cells.size(), 1u);
  for (const Cell& c : cells) EXPECT_LE(c.points, kCellPoints);
}

TEST(Cells, PointsInOnePlaceAreOneCell) {
  const CloudStore cloud(std::vector<Index3>(kCellPoints + 5, Index3{-7, 8, 9}));
  const auto cells = canonical_cells(cloud.store(), 1);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].points, kCellPoints + 5);
  write_normals(cloud.store());
  EXPECT_EQ(load_cell(cloud.store(), cells[0]).size, kCellPoints + 5);
}

// Oracle: the filter of all points by the box of the cell and by the same box a sixteenth of its edge wider.
TEST(Cells, PointsAreThoseOfTheCellAndItsMargin) {
  const auto points = spread(8000, 2);
  for (const std::uint64_t block_points : {1u << 20, 300u}) {
    const CloudStore cloud(points, {block_points, 1u << 20, 1});
    write_normals(cloud.store());
    const auto all = test::in_global_order(points);
    const auto cells = canonical_cells(cloud.store(), kMetre);
    for (std::size_t c = 0; c < cells.size(); c += 5) {
      const IndexBox box = cells[c].node.box();
      const CellPoints cp = load_cell(cloud.store(), cells[c]);
      std::size_t at = 0;
      for (const Index3& p : all) {
        if (!box.grown(4).contains(p)) continue;
        ASSERT_LT(at, cp.size);
        ASSERT_EQ(
            (Index3{static_cast<std::int64_t>(cp.x[at]) + box.min.x, static_cast<std::int64_t>(cp.y[at]) + box.min.y,
                    static_cast<std::int64_t>(cp.z[at]) + box.min.z}),
            p);
        ASSERT_EQ(cp.core[at] != 0, box.contains(p));
        ASSERT_EQ(cp.normals[at], normal_of(key_of(p).code));
        ++at;
      }
      ASSERT_EQ(at, cp.size);
      ASSERT_GE(cp.x.size(), cp.size + 16);
    }
  }
}

}  // namespace
}  // namespace ilot
