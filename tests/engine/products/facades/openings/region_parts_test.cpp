// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/region_parts.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

// A wall of cells of 5 cm with an opening where `open` says so.
template <class Open>
std::vector<CellRegion> parts_where(const Open& open, const WidthOfWall& width = {}) {
  WallCells cells;
  cells.cell = 0.05, cells.columns = 80, cells.rows = 60;
  cells.what.assign(80 * 60, WallCells::kSolid);
  for (std::int64_t r = 0; r < cells.rows; ++r)
    for (std::int64_t c = 0; c < cells.columns; ++c)
      if (open(c, r)) cells.at(c, r) = WallCells::kThrough;
  std::vector<CellRegion> parts;
  for_each_region(
      cells, [&](std::size_t i) { return cells.what[i] == WallCells::kThrough; },
      [&](const CellRegion& region) {
        for (RegionPart& part : parts_of_region(cells, region, 0.3, width)) parts.push_back(std::move(part.region));
      });
  return parts;
}

bool within(std::int64_t c, std::int64_t r, std::int64_t c0, std::int64_t c1, std::int64_t r0, std::int64_t r1) {
  return c >= c0 && c < c1 && r >= r0 && r < r1;
}

TEST(RegionParts, TwoWindowsThatAFewCellsConnectAreTwo) {
  const auto parts = parts_where([](auto c, auto r) {
    return within(c, r, 10, 30, 10, 40) || within(c, r, 35, 55, 10, 40) || within(c, r, 30, 35, 20, 22);
  });
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(box_of(parts[0], 80).c1, 29);
  EXPECT_EQ(box_of(parts[1], 80).c0, 35);
  // The same above each other.
  EXPECT_EQ(parts_where([](auto c, auto r) {
              return within(c, r, 10, 30, 5, 25) || within(c, r, 10, 30, 30, 50) || within(c, r, 20, 22, 25, 30);
            }).size(),
            2u);
}

TEST(RegionParts, AStripThatCellsDoNotTellFromABarIsMeasured) {
  const auto windows = [](auto c, auto r) {
    return within(c, r, 10, 30, 10, 40) || within(c, r, 32, 52, 10, 40) || within(c, r, 30, 32, 20, 22);
  };
  std::vector<std::int64_t> measured;
  const auto width = [&](double metres) {
    return [&measured, metres](const CellBox&, std::int64_t column) {
      measured.push_back(column);
      return metres;
    };
  };
  EXPECT_EQ(parts_where(windows, width(0.1)).size(), 1u);
  EXPECT_EQ(parts_where(windows, width(0.2)).size(), 2u);
  for (const std::int64_t column : measured) EXPECT_TRUE(column == 30 || column == 31);
}

TEST(RegionParts, WhatLiesOnAPierIsNoPartOfTheRegion) {
  // Cells were joined over leaves on a pier: they are in the region, and the image shows them as relief.
  WallCells seen;
  seen.cell = 0.05, seen.columns = 80, seen.rows = 60;
  seen.what.assign(80 * 60, WallCells::kSolid);
  CellRegion region;
  for (std::int64_t r = 10; r < 40; ++r)
    for (std::int64_t c = 10; c < 55; ++c) {
      seen.at(c, r) = within(c, r, 30, 35, 10, 40) ? WallCells::kRelief : WallCells::kThrough;
      region.cells.push_back(static_cast<std::uint32_t>(r * 80 + c));
    }
  const auto parts = parts_of_region(seen, region, 0.3);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(parts[0].at_pier && parts[1].at_pier);
}

TEST(RegionParts, BarsAndArchesAreNotCut) {
  EXPECT_EQ(parts_where([](auto c, auto r) {
              return within(c, r, 10, 30, 10, 40) || within(c, r, 32, 52, 10, 40) || within(c, r, 30, 32, 20, 22);
            }).size(),
            1u);
  EXPECT_EQ(parts_where([](auto c, auto r) {
              return within(c, r, 10, 40, 5, 30) || (r >= 30 && (c - 25) * (c - 25) + (r - 30) * (r - 30) < 225);
            }).size(),
            1u);
}

}  // namespace
}  // namespace ilot
