// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/split_merge.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY;

SplitMergeParams split_params(double epsilon) {
  SplitMergeParams p;
  p.epsilon = epsilon;
  p.tolerance = epsilon / 3;
  p.max_step = epsilon / 2;
  p.min_edge = 40;
  return p;
}

TEST(SplitMerge, OneFlatCellIsOneSegment) {
  const auto set =
      test::make_set("flat", {{0, 0, 7}, {9, 0, 7}, {0, 9, 7}, {9, 9, 7}, {4, 5, 7}, {3, 3, 7}, {5, 4, 7}});
  SplitMergeParams params = split_params(1);
  params.min_points = 7;
  const auto s = split_merge(set.view(), params);
  ASSERT_EQ(s.planes.size(), 1u);
  EXPECT_NEAR(s.planes[0].d, -7, 1e-12);
  EXPECT_EQ(s.label, std::vector<std::uint32_t>(7, 1));
  params.min_points = 8;
  EXPECT_TRUE(split_merge(set.view(), params).planes.empty());
}

TEST(SplitMerge, TheFacesOfABoxAreSplit) {
  for (const std::uint64_t key : {1, 2, 3}) {
    const auto set = test::box_corner(key, 3, 200);
    const auto s = split_merge(set.view().points, split_params(12));
    test::expect_sound(set, s, 12, 30);
    ASSERT_GE(s.planes.size(), 3u);
    const auto count = test::label_sizes(s);
    EXPECT_GT(count[1] + count[2] + count[3], 0.96 * 7400) << key;  // points near the edges fit either face
    EXPECT_GT(std::abs(s.planes[0].n.z), 0.9999);
  }
}

TEST(SplitMerge, StackedSurfacesStayApart) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 500}, kX, kY, 38, 38, 20, 1});
  b.add(test::Patch{{0, 0, 650}, kX, kY, 38, 38, 20, 1});
  const auto set = b.build();
  const auto s = split_merge(set.view().points, split_params(10));
  test::expect_sound(set, s, 10, 30);
  EXPECT_EQ(test::label_sizes(s), (std::vector<std::size_t>{0, 1444, 1444}));
}

TEST(SplitMerge, AnyOrderOfPointsAndAnyPlaceGiveTheSegments) {
  const auto set = test::box_corner(5);
  const auto mixed = test::shuffled(set, 6);
  const auto a = split_merge(set.view().points, split_params(12));
  EXPECT_EQ(a.label, test::in_original_order(mixed, split_merge(mixed.set.view().points, split_params(12)).label));
  auto moved = set;
  for (std::size_t i = 0; i < set.size; ++i) moved.x[i] += 12345;
  EXPECT_EQ(a.label, split_merge(moved.view().points, split_params(12)).label);
}

TEST(SplitMerge, DegenerateInputHasNoSegments) {
  EXPECT_TRUE(split_merge({}, split_params(1)).planes.empty());
  for (const auto& set : test::point_sets(300)) {
    const auto s = split_merge(set.view(), split_params(2));
    EXPECT_EQ(s.label.size(), set.size);
    if (set.name == "line") {
      EXPECT_TRUE(s.planes.empty());
    }
  }
}

}  // namespace
}  // namespace ilot
