// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/region_planes.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY, test::kZ;

Regions one_region(std::size_t n) {
  return {std::vector<std::uint32_t>(n, 1), 1, {0}};
}

TEST(RegionPlanes, AFlatRegionIsItsLeastSquaresPlane) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 100}, kX, kY, 20, 20, 10, 0});
  const auto set = b.build();
  for (const auto estimate : {PlaneEstimate::kMeanNormal, PlaneEstimate::kLeastSquares, PlaneEstimate::kBest}) {
    const auto s = planes_of_regions(set.view().points, one_region(set.size), {1, 10, 20, estimate});
    ASSERT_EQ(s.planes.size(), 1u);
    EXPECT_NEAR(s.planes[0].n.z, 1, 1e-12);
    EXPECT_NEAR(s.planes[0].d, -100, 1e-9);
    EXPECT_EQ(test::label_sizes(s), (std::vector<std::size_t>{0, 400}));
  }
}

// A region that leaked round an edge: two faces of a box in one region.
TEST(RegionPlanes, ALeakIsSplitIntoItsPlanes) {
  for (const std::uint64_t key : {1, 2, 3}) {
    test::OrientedSetBuilder b(key);
    b.add(test::Patch{{500, 500, 500}, kX, kY, 40, 30, 20, 2});
    b.add(test::Patch{{500, 500, 520}, kZ, kY, 40, 30, 20, 2});
    const auto set = b.build();
    const auto s = planes_of_regions(set.view().points, one_region(set.size), {10, 50, 60, PlaneEstimate::kBest});
    test::expect_sound(set, s, 10, 50);
    ASSERT_EQ(s.planes.size(), 2u);
    EXPECT_LE(test::label_sizes(s)[0], 20u);  // noise of a fifth of epsilon: hardly any point is left
    EXPECT_GT(std::max(std::abs(s.planes[0].n.z), std::abs(s.planes[1].n.z)), 0.9999);
    EXPECT_GT(std::max(std::abs(s.planes[0].n.x), std::abs(s.planes[1].n.x)), 0.9999);
  }
}

TEST(RegionPlanes, EpsilonMeansEpsilonForEveryEstimate) {
  const auto set = test::box_corner(5, 8);
  const auto near = test::neighbours_of(set.view().points, 16);
  const auto regions = grow_smooth(set.view().points, test::packed_normals(set), near.lists(), {0.95, 1, 100, 20});
  std::size_t most = 0, mean = 0, squares = 0;
  for (const auto estimate : {PlaneEstimate::kMeanNormal, PlaneEstimate::kLeastSquares, PlaneEstimate::kBest}) {
    const auto s = planes_of_regions(set.view().points, regions, {12, 20, 60, estimate});
    test::expect_sound(set, s, 12, 20);
    const std::size_t labelled = set.size - test::label_sizes(s)[0];
    (estimate == PlaneEstimate::kBest ? most : estimate == PlaneEstimate::kMeanNormal ? mean : squares) = labelled;
  }
  EXPECT_GT(mean, 5000u);
  EXPECT_GT(squares, 6000u);
  EXPECT_GT(most, 6000u);
}

TEST(RegionPlanes, AnyOrderOfPointsGivesThePlanes) {
  const auto set = test::box_corner(6, 3, 0);
  const auto mixed = test::shuffled(set, 8);
  const auto run = [](const test::OrientedSet& s) {
    const auto near = test::neighbours_of(s.view().points, 12);
    const auto regions = grow_by_pairs(s.view().points, test::packed_normals(s), near.lists(), {0.99, 30, 60, 30});
    return planes_of_regions(s.view().points, regions, {12, 30, 60, PlaneEstimate::kLeastSquares});
  };
  const auto a = run(set), b = run(mixed.set);
  ASSERT_EQ(a.planes.size(), 3u);
  EXPECT_EQ(test::canonical(a.label), test::canonical(test::in_original_order(mixed, b.label)));
}

TEST(RegionPlanes, DegenerateRegionsGiveNoPlane) {
  EXPECT_TRUE(planes_of_regions({}, {}, {}).planes.empty());
  const auto line = test::point_sets(50)[3];
  const auto s = planes_of_regions(line.view(), one_region(50), {1, 3, 10});
  EXPECT_TRUE(s.planes.empty());
  EXPECT_EQ(s.label, std::vector<std::uint32_t>(50, 0));
}

}  // namespace
}  // namespace ilot
