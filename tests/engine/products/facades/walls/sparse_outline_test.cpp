// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/sparse_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ilot {
namespace {

constexpr double kSparseStep = 0.2;
const Box2 kWithParts{-2, 10, 0, 8};
const WallOutline kDense{{{0, 0}, {6, 0}, {6, 8}, {0, 8}}, {}};

std::vector<SparseColumn> columns_from(double u, const std::vector<double>& tops) {
  std::vector<SparseColumn> columns;
  for (std::size_t i = 0; i < tops.size(); ++i)
    columns.push_back({u + 0.5 * static_cast<double>(i), u + 0.5 * static_cast<double>(i + 1), tops[i]});
  return columns;
}

std::vector<SparseColumn> all_columns(const std::vector<double>& left, const std::vector<double>& right) {
  std::vector<SparseColumn> columns = columns_from(6, right);
  for (const SparseColumn& c : columns_from(-2, left)) columns.push_back(c);
  return columns;
}

void expect_ring(const WallOutline& outline, const std::vector<Place2>& truth) {
  ASSERT_EQ(outline.ring.size(), truth.size());
  ASSERT_EQ(outline.edges.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_DOUBLE_EQ(outline.ring[i].u, truth[i].u) << i;
    EXPECT_DOUBLE_EQ(outline.ring[i].v, truth[i].v) << i;
    EXPECT_GE(outline.edges[i].error_m, kSparseStep) << i;
  }
}

// A tall house, a sparse low one right of it, and its own sparse end at the left.
TEST(SparseOutline, ALowHouseBesideATallOneIsNoSky) {
  const auto columns = all_columns({7.9, 7.8, 7.9, 8}, {4, 4.1, 4, 3.9, 4, 4, 4.1, 4});
  expect_ring(outline_with_columns(kDense, 6, columns, kWithParts, kSparseStep),
              {{-2, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 8}, {-2, 8}});
}

// What hides the wall, and what lies between two windows, is no gap in it.
TEST(SparseOutline, GapsAndBareColumnsTakeWhatIsBesideThem) {
  const auto columns = all_columns({7.9, 7.9, 2, 8}, {4, 4, -INFINITY, 4, 1, 2, 4, 4});
  expect_ring(outline_with_columns(kDense, 6, columns, kWithParts, kSparseStep),
              {{-2, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 8}, {-2, 8}});
}

TEST(SparseOutline, ABareEndIsAsHighAsTheWall) {
  WallOutline low = kDense;
  low.ring[2].v = low.ring[3].v = 5;
  low.edges.assign(4, {});
  expect_ring(outline_with_columns(low, 6, columns_from(6, {-INFINITY}), {0, 6.5, 0, 8}, kSparseStep),
              {{0, 0}, {6.5, 0}, {6.5, 5}, {0, 5}});
}

TEST(SparseOutline, AWallThatGoesOnAboveIsItsBox) {
  expect_ring(outline_with_columns(kDense, 6, {}, kWithParts, kSparseStep), {{-2, 0}, {10, 0}, {10, 8}, {-2, 8}});
}

}  // namespace
}  // namespace ilot
