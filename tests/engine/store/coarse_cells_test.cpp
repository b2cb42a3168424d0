// SPDX-License-Identifier: Apache-2.0
#include "engine/store/coarse_cells.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

constexpr int kCellBits = 19;

CoarseCells counted(std::span<const Index3> points) {
  CoarseCells cells(kCellBits);
  for (const Index3& p : points) cells.add(p);
  return cells;
}

// Tile by tile, as sorted runs come.
CoarseCells counted_sorted(std::span<const Index3> points) {
  std::map<Tile, std::vector<KeyValue>> tiles;
  for (const Index3& p : points) tiles[key_of(p).tile].push_back({key_of(p).code, 0});
  CoarseCells cells(kCellBits);
  for (auto& [tile, keys] : tiles) {
    std::sort(keys.begin(), keys.end());
    cells.add(tile, keys);
  }
  return cells;
}

std::vector<Index3> scattered(std::size_t n, std::int64_t reach, std::uint64_t key) {
  Rng rng(key);
  const auto within = [&] {
    return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(2 * reach))) - reach;
  };
  std::vector<Index3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({within(), within(), within()});
  return points;
}

// Oracle: all points of a cell in a set.
TEST(CoarseCells, CountPointsAndPlaces) {
  const auto points = test::points_over_tiles(20000, 7);
  std::map<CoarseCell, std::set<PointKey>> places;
  std::map<CoarseCell, std::uint64_t> count;
  for (const Index3& p : points) {
    places[coarse_cell(p, kCellBits)].insert(key_of(p));
    ++count[coarse_cell(p, kCellBits)];
  }
  const CoarseCells cells = counted(points);
  ASSERT_EQ(cells.bits(), kCellBits);
  ASSERT_EQ(cells.cells().size(), places.size());
  std::size_t few = 0;
  for (const auto& [cell, content] : cells.cells()) {
    EXPECT_EQ(content.points, count[cell]);
    EXPECT_EQ(content.many, places[cell].size() >= kFewPlaces);
    EXPECT_EQ(content.places.size(), content.many ? 0 : places[cell].size());
    for (const Index3& p : content.places) EXPECT_TRUE(places[cell].contains(key_of(p)));
    few += !content.many;
  }
  EXPECT_GT(few, 0u);
  EXPECT_LT(few, places.size());
}

TEST(CoarseCells, NeitherOrderNorPartsShow) {
  // The third is spread over so many cells that these are doubled again and again.
  const std::vector<std::vector<Index3>> clouds{test::points_over_tiles(5000, 1), scattered(3000, 30000000, 2),
                                                scattered(40000, std::int64_t{1} << 45, 3)};
  for (auto points : clouds) {
    const auto wanted = counted(points).packed();
    EXPECT_EQ(counted_sorted(points).packed(), wanted);
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(counted(points).packed(), wanted);
    const std::span<const Index3> all(points);
    for (const std::size_t parts : {2u, 7u}) {
      CoarseCells merged(kCellBits);
      for (std::size_t p = 0; p < parts; ++p) {
        const std::size_t from = all.size() * p / parts, to = all.size() * (p + 1) / parts;
        merged.merge(p % 2 ? counted(all.subspan(from, to - from)) : counted_sorted(all.subspan(from, to - from)));
      }
      EXPECT_EQ(merged.packed(), wanted);
    }
  }
  const CoarseCells wide = counted(clouds[2]);
  EXPECT_GT(wide.bits(), kCellBits);
  EXPECT_LE(wide.cells().size(), kMostCoarseCells);
}

TEST(CoarseCells, AreReadAsTheyWereWritten) {
  const CoarseCells cells = counted(test::points_over_tiles(5000, 4));
  const CoarseCells read = CoarseCells::unpacked(cells.packed());
  EXPECT_EQ(read.packed(), cells.packed());
  EXPECT_EQ(read.bits(), cells.bits());
  EXPECT_TRUE(CoarseCells::unpacked(CoarseCells(12).packed()).cells().empty());
}

TEST(CoarseCells, AreAtMost600MetresWide) {
  EXPECT_EQ(coarse_bits(0.001), 19);
  EXPECT_EQ(coarse_bits(0.01), 15);
  EXPECT_EQ(coarse_bits(0.00001), 25);
  EXPECT_EQ(coarse_bits(1000), 0);
  EXPECT_EQ(coarse_bits(1e-300), 40);
}

}  // namespace
}  // namespace ilot
