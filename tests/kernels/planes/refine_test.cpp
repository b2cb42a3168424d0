// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/refine.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

TEST(Refine, TinyExactCase) {
  const auto set = test::make_set("tiny", {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 0}, {5, 5, 3}, {5, 5, 9}});
  const auto r = refine_plane({set.view()}, test::all_of(6), {{0, 0, 1}, -0.4}, {1, 0, 3});
  EXPECT_EQ(r.members.size(), 4u);
  EXPECT_EQ(r.end, RefinedPlane::End::kConverged);
  EXPECT_NEAR(r.plane.d, 0, 1e-12);
  EXPECT_NEAR(r.plane.n.z, 1, 1e-12);
}

TEST(Refine, MembersAreThoseOfTheFinalPlane) {
  for (const std::uint64_t key : {1, 2, 3}) {
    const auto set = test::box_corner(key);
    const auto all = test::all_of(set.size);
    for (const int rounds : {0, 1, 2, 10}) {
      const RefineParams params{9, 0.9, 10, rounds};
      const auto r = refine_plane(set.view(), all, {{0, 0.02, 0.9998}, -2035}, params);
      EXPECT_EQ(r.members, consensus_set(set.view(), all, r.plane, params));
      EXPECT_LE(r.rounds, rounds);
      if (r.end == RefinedPlane::End::kCapped) {
        EXPECT_EQ(r.rounds, rounds);
      }
    }
  }
}

TEST(Refine, ConvergesOnTheFaceFromATiltedStart) {
  const auto set = test::box_corner(4);
  const Vec3 n{0.02, 0.02, 1};
  const Plane start{(1 / norm(n)) * n, -(1 / norm(n)) * dot(n, Vec3{2500, 2500, 2000})};
  const auto r = refine_plane(set.view(), test::all_of(set.size), start, {12, 0.95, 3, 30});
  EXPECT_EQ(r.end, RefinedPlane::End::kConverged);
  EXPECT_GE(r.members.size(), 2990u);  // 3,000 points with noise of a quarter of epsilon
  EXPECT_GT(r.plane.n.z, 0.99999);
}

TEST(Refine, DegenerateInputKeepsTheStart) {
  const Plane start{{0, 0, 1}, -5};
  const auto line = test::point_sets(50)[3];
  EXPECT_TRUE(refine_plane({Points{}}, {}, start, {1}).members.empty());
  const auto r = refine_plane({line.view()}, test::all_of(50), start, {1e6});
  EXPECT_EQ(r.plane.d, start.d);  // all on a line: no least-squares plane
  EXPECT_EQ(r.members.size(), 50u);
  EXPECT_EQ(r.rounds, 0);
}

}  // namespace
}  // namespace ilot
