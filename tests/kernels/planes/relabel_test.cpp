// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/relabel.h"

#include <numeric>

#include "kernels/core/rng.h"
#include "kernels/neighbours/knn.h"
#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY;

test::OrientedSet floor_of(int columns, int rows) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 100}, kX, kY, columns, rows, 10, 0});
  return b.build();
}

TEST(Relabel, StraysSpreadFromLabelledPointsRoundByRound) {
  const auto set = floor_of(20, 20);
  const auto near = test::neighbours_of(set.view().points, 9);
  PlaneSegments s{std::vector<std::uint32_t>(set.size, 0), {{{0, 0, 1}, -100}}};
  for (std::size_t i = 0; i < set.size; ++i) s.label[i] = set.x[i] <= 10;  // two columns of twenty
  PlaneSegments one = s;
  EXPECT_EQ(assign_unlabelled(set.view().points, near.lists(), {1, 20, 2, 1}, one), 20u);
  EXPECT_EQ(assign_unlabelled(set.view().points, near.lists(), {1, 20, 2, 100}, s), 360u);
  EXPECT_EQ(test::label_sizes(s), (std::vector<std::size_t>{0, 400}));
}

TEST(Relabel, APointGoesToTheNearerPlaneWithinEpsilonOnly) {
  const auto set = test::make_set("cross", {{0, 0, 10}, {2, 0, 10}, {0, 2, 12}, {2, 2, 12}, {1, 1, 11}, {1, 1, 30}});
  const auto near = test::neighbours_of(set.view(), 6);
  PlaneSegments start{std::vector<std::uint32_t>(6, 0), {{{0, 0, 1}, -10.4}, {{0, 0, 1}, -12}}};
  for (std::size_t i = 0; i < 6; ++i) start.label[i] = set.z[i] == 10 ? 1 : set.z[i] == 12 ? 2 : 0;
  PlaneSegments wide = start, narrow = start, lonely = start;
  EXPECT_EQ(assign_unlabelled(set.view(), near.lists(), {2, 100, 2, 5}, wide), 1u);
  for (std::size_t i = 0; i < 6; ++i)
    if (set.z[i] == 11) {
      EXPECT_EQ(wide.label[i], 1u);  // 0.6 from the first, 1 from the second
    }
  EXPECT_EQ(assign_unlabelled(set.view(), near.lists(), {0.5, 100, 2, 5}, narrow), 0u);
  EXPECT_EQ(assign_unlabelled(set.view(), near.lists(), {2, 100, 3, 5}, lonely), 0u);
}

TEST(Relabel, IslandsGoToTheMajorityUnlessTheyLieElsewhere) {
  const auto set = floor_of(20, 20);
  const auto near = test::neighbours_of(set.view().points, 13);
  PlaneSegments s{std::vector<std::uint32_t>(set.size, 1), {{{0, 0, 1}, -100}, {{0, 0, 1}, -100.5}}};
  std::size_t island = 0;
  for (std::size_t i = 0; i < set.size; ++i)
    if (set.x[i] == 100 && (set.y[i] == 100 || set.y[i] == 110)) s.label[island = i] = 2;
  PlaneSegments kept = s;
  EXPECT_EQ(relabel_islands(set.view().points, near.lists(), {1, 50}, s), 2u);
  EXPECT_EQ(s.label[island], 1u);
  kept.planes[0].d = -103;  // now too far away
  EXPECT_EQ(relabel_islands(set.view().points, near.lists(), {1, 50}, kept), 0u);
}

TEST(Relabel, BordersCanFollowTheNearestPlane) {
  const auto set = test::make_set("steps", {{0, 0, 10}, {1, 0, 10}, {0, 1, 14}, {1, 1, 14}, {2, 1, 13}, {2, 0, 12}});
  const auto near = test::neighbours_of(set.view(), 6);
  PlaneSegments s{std::vector<std::uint32_t>(6, 1), {{{0, 0, 1}, -10}, {{0, 0, 1}, -14}}};
  for (std::size_t i = 0; i < 6; ++i) s.label[i] = set.z[i] == 14 ? 2 : 1;
  RelabelParams params{3, 100, 2, 4};
  params.border = RelabelParams::Border::nearest;
  EXPECT_EQ(split_borders(set.view(), near.lists(), params, s), 1u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(s.label[i], set.z[i] >= 13 ? 2u : 1u) << "a tie keeps its own";
}

// A convex edge between z = 1000 and x = 1000, with noise: labels start at the wrong side for a band along the edge.
TEST(Relabel, BordersFollowTheBisector) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{800, 0, 1000}, kX, kY, 40, 60, 5, 1});
  b.add(test::Patch{{1000, 0, 800}, kY, {0, 0, 1}, 60, 40, 5, 1});
  const auto set = b.build();
  const auto near = test::neighbours_of(set.view().points, 13);
  PlaneSegments s{std::vector<std::uint32_t>(set.size, 0), {{{0, 0, 1}, -1000}, {{1, 0, 0}, -1000}}};
  const auto on_top = [&](std::size_t i) { return set.x[i] - 1000 < set.z[i] - 1000; };
  std::size_t band = 0;
  for (std::size_t i = 0; i < set.size; ++i) {
    s.label[i] = on_top(i) ? 1 : 2;
    const bool stolen = on_top(i) && std::abs(set.x[i] - 1000) <= 8;
    if (stolen) s.label[i] = 2;
    band += stolen;
  }
  EXPECT_GE(band, 60u);
  EXPECT_GE(split_borders(set.view().points, near.lists(), {9, 40}, s), band - 5);
  test::expect_sound(set, s, 12, 1);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < set.size; ++i) wrong += s.label[i] != (on_top(i) ? 1u : 2u);
  EXPECT_LE(wrong, 5u);
}

// A strip of the face beside it tilts a narrow plane; settling gives the strip back and sets the plane upright.
TEST(Relabel, SettlingUndoesATilt) {
  test::OrientedSetBuilder b(2);
  b.add(test::Patch{{600, 0, 1000}, kX, kY, 80, 60, 5, 1});
  b.add(test::Patch{{1000, 0, 975}, kY, {0, 0, 1}, 60, 5, 5, 1});
  const auto set = b.build();
  const auto near = test::neighbours_of(set.view().points, 13);
  PlaneSegments s{std::vector<std::uint32_t>(set.size, 0), {{{0, 0, 1}, -1000}, {{0.995, 0, 0.0998749}, -1093.6}}};
  for (std::size_t i = 0; i < set.size; ++i)
    s.label[i] = std::abs(signed_distance(s.planes[1], set.position(i))) <= 5   ? 2
                 : std::abs(signed_distance(s.planes[0], set.position(i))) <= 5 ? 1
                                                                                : 0;
  relabel_until_stable(set.view().points, near.lists(), {5, 20}, 100, s);
  test::expect_sound(set, s, 5, 100);
  ASSERT_EQ(s.planes.size(), 2u);
  EXPECT_GT(std::abs(s.planes[1].n.x), 0.9986);  // 3 degrees; it started with 5.7
  relabel_until_stable(set.view().points, near.lists(), {5, 20}, 5000, s);
  EXPECT_TRUE(s.planes.empty());
}

TEST(Relabel, OrderDoesNotMatter) {
  const auto set = test::box_corner(2, 3, 200);
  const auto mixed = test::shuffled(set, 3);
  const auto run = [](const test::OrientedSet& s) {
    const auto near = test::neighbours_of(s.view().points, 12);
    PlaneSegments segments{std::vector<std::uint32_t>(s.size, 0), {{{0, 0, 1}, -2000}, {{1, 0, 0}, -2000}}};
    for (std::size_t i = 0; i < s.size; ++i)
      if (static_cast<int>(s.x[i] + s.y[i] + s.z[i]) % 3 == 0)
        segments.label[i] = s.nz[i] > 0.9F ? 1 : s.nx[i] > 0.9F ? 2 : 0;
    assign_unlabelled(s.view().points, near.lists(), {12, 60, 2, 8}, segments);
    relabel_islands(s.view().points, near.lists(), {12, 60}, segments);
    return segments;
  };
  EXPECT_EQ(run(set).label, test::in_original_order(mixed, run(mixed.set).label));
}

TEST(Relabel, NothingToDo) {
  PlaneSegments none;
  EXPECT_EQ(assign_unlabelled({}, {{}, 8}, {}, none), 0u);
  EXPECT_EQ(relabel_islands({}, {{}, 8}, {}, none), 0u);
  EXPECT_EQ(split_borders({}, {{}, 8}, {}, none), 0u);
}

// Runs of consecutive points are passed over where nothing can happen; mixed up, hardly any run is. Two walls meet a
// floor, labels start at the wrong side for a band along the edges, and many floor points are far from both.
TEST(Relabel, TheOrderOfPointsDoesNotShow) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 1000}, kX, kY, 120, 100, 10, 2});
  b.add(test::Patch{{0, 0, 1000}, kX, {0, 0, 1}, 120, 60, 10, 2});
  b.add(test::Patch{{0, 0, 1000}, kY, {0, 0, 1}, 100, 60, 10, 2});
  const auto set = b.build();
  const auto near = test::neighbours_of(set.view().points, 16);
  PlaneSegments s{std::vector<std::uint32_t>(set.size), {{{0, 0, 1}, -1000}, {{0, 1, 0}, 0}, {{1, 0, 0}, 0}}};
  for (std::size_t i = 0; i < set.size; ++i)
    s.label[i] = set.z[i] < 1025 ? 1 : set.y[i] < 25 ? 2 : set.x[i] < 15 ? 3 : 1;
  std::vector<std::uint32_t> place(set.size);  // where each point stands in the mixed set
  std::iota(place.begin(), place.end(), 0u);
  Rng rng(5);
  for (std::size_t i = place.size(); i-- > 1;) std::swap(place[i], place[rng.below(i + 1)]);
  std::vector<float> x(set.size), y(set.size), z(set.size);
  std::vector<std::uint32_t> lists(set.size * 16);
  PlaneSegments mixed{std::vector<std::uint32_t>(set.size), s.planes};
  for (std::uint32_t i = 0; i < set.size; ++i) {
    x[place[i]] = set.x[i], y[place[i]] = set.y[i], z[place[i]] = set.z[i];
    mixed.label[place[i]] = s.label[i];
    for (std::size_t k = 0; k < 16; ++k) {
      const std::uint32_t j = near.lists().of(i)[k];
      lists[place[i] * std::size_t{16} + k] = j == kNoNeighbour ? j : place[j];
    }
  }
  const RelabelParams params{6, 100, 2, 8};
  const std::size_t moves = split_borders(set.view().points, near.lists(), params, s);
  EXPECT_GT(moves, 100u);
  EXPECT_EQ(split_borders({x.data(), y.data(), z.data(), set.size}, {lists, 16}, params, mixed), moves);
  for (std::size_t i = 0; i < set.size; ++i) ASSERT_EQ(mixed.label[place[i]], s.label[i]) << i;
}

}  // namespace
}  // namespace ilot
