// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/neighbour_index.h"

#include <gtest/gtest.h>

#include <cfloat>

#include "tests/support/point_sets.h"

namespace ilot {
namespace {

float box_value(const NeighbourIndex& index, std::size_t level, std::size_t child, std::size_t row) {
  return index.boxes[level][child / 8 * 48 + row * 8 + child % 8];
}

std::size_t ceil_div(std::size_t a, std::size_t b) {
  return (a + b - 1) / b;
}

TEST(NeighbourIndex, NineByHand) {
  std::vector<Cell3> cells;
  for (std::uint32_t i = 0; i < 9; ++i) cells.push_back({10 * i, 0, 0});
  const auto set = test::make_set("nine", cells);
  const NeighbourIndex index = build_neighbour_index(set.view());
  ASSERT_EQ(index.boxes.size(), 1u);
  ASSERT_EQ(index.boxes[0].size(), 48u);
  EXPECT_EQ(box_value(index, 0, 0, 0), 0);
  EXPECT_EQ(box_value(index, 0, 0, 3), 70);
  EXPECT_EQ(box_value(index, 0, 1, 0), 80);
  EXPECT_EQ(box_value(index, 0, 1, 3), 80);
  EXPECT_EQ(box_value(index, 0, 2, 0), FLT_MAX);  // absent: at the far end
}

TEST(NeighbourIndex, EveryBoxIsTheTightBoxOfItsPoints) {
  for (const std::uint32_t n : {1u, 7u, 8u, 9u, 63u, 64u, 65u, 512u, 513u, 5000u}) {
    for (const auto& set : test::point_sets(n)) {
      const NeighbourIndex index = build_neighbour_index(set.view());
      std::size_t points_a_child = 8;
      for (std::size_t level = 0; level < index.boxes.size(); ++level, points_a_child *= 8) {
        const std::size_t children = ceil_div(n, points_a_child);
        ASSERT_EQ(index.boxes[level].size(), ceil_div(children, 8) * 48);
        for (std::size_t child = 0; child < ceil_div(children, 8) * 8; ++child) {
          const float* columns[3]{set.x.data(), set.y.data(), set.z.data()};
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t begin = child * points_a_child, end = std::min<std::size_t>(n, begin + points_a_child);
            const bool present = begin < n;
            const float low = present ? *std::min_element(columns[axis] + begin, columns[axis] + end) : FLT_MAX;
            const float high = present ? *std::max_element(columns[axis] + begin, columns[axis] + end) : FLT_MAX;
            ASSERT_EQ(box_value(index, level, child, axis), low) << set.name << " n=" << n << " level " << level;
            ASSERT_EQ(box_value(index, level, child, axis + 3), high) << set.name << " n=" << n << " level " << level;
          }
        }
      }
      EXPECT_EQ(index.boxes.back().size(), 48u) << "the top is one node";
    }
  }
}

TEST(NeighbourIndex, NoPointsGiveNoBoxes) {
  const NeighbourIndex index = build_neighbour_index({});
  ASSERT_EQ(index.boxes.size(), 1u);
  EXPECT_TRUE(index.boxes[0].empty());
}

}  // namespace
}  // namespace ilot
