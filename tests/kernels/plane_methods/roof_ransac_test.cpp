// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/roof_ransac.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY;

RoofRansacParams roof_params(std::uint64_t key) {
  RoofRansacParams p;
  p.epsilon = 83;  // 1/12 m in millimetres
  p.stray_gap = 1000;
  p.key = key;
  return p;
}

// A gable roof of 12 m x 8 m at 10 points a square metre, and a flat annexe.
test::OrientedSet roof(std::uint64_t key, double noise) {
  test::OrientedSetBuilder b(key);
  const double c = 0.8, s = 0.6;
  const double step = 316;
  b.add(test::Patch{{1000, 1000, 5000}, kX, {0, c, s}, 38, 16, step, noise});
  b.add(test::Patch{{1000, 1000 + 2 * 4000, 5000}, kX, {0, -c, s}, 38, 16, step, noise});
  b.add(test::Patch{{14000, 2000, 4000}, kX, kY, 14, 14, step, noise});
  return b.build();
}

TEST(RoofRansac, AGableAndItsAnnexeAreThreeFaces) {
  for (const std::uint64_t key : {1, 2, 3, 4}) {
    const auto set = roof(key, 20);
    const auto near = test::neighbours_of(set.view().points, 13);
    const auto s = roof_ransac(set.view().points, near.lists(), roof_params(key));
    test::expect_sound(set, s, 83, 100);
    ASSERT_EQ(s.planes.size(), 3u) << key;
    std::vector<double> up;
    for (const Plane& p : s.planes) up.push_back(p.n.z);
    std::sort(up.begin(), up.end());
    EXPECT_NEAR(up[0], 0.8, 0.01);
    EXPECT_NEAR(up[1], 0.8, 0.01);
    EXPECT_GT(up[2], 0.999);
    EXPECT_LT(test::label_sizes(s)[0], set.size / 50);
  }
}

// Two faces in one plane, a gap apart: one at a time.
TEST(RoofRansac, StraysOfTheSamePlaneAreAFaceOfTheirOwn) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 5000}, kX, kY, 20, 20, 300, 10});
  b.add(test::Patch{{12000, 0, 5000}, kX, kY, 15, 15, 300, 10});
  const auto set = b.build();
  const auto near = test::neighbours_of(set.view().points, 13);
  const auto s = roof_ransac(set.view().points, near.lists(), roof_params(5));
  EXPECT_EQ(test::label_sizes(s), (std::vector<std::size_t>{0, 400, 225}));
}

TEST(RoofRansac, KeyAndPointsAreAllThatMatters) {
  const auto set = roof(7, 20);
  const auto near = test::neighbours_of(set.view().points, 13);
  const auto a = roof_ransac(set.view().points, near.lists(), roof_params(1));
  EXPECT_EQ(a.label, roof_ransac(set.view().points, near.lists(), roof_params(1)).label);
  const auto other = roof_ransac(set.view().points, near.lists(), roof_params(2));
  std::size_t moved = 0;
  const auto x = test::canonical(a.label), y = test::canonical(other.label);
  for (std::size_t i = 0; i < set.size; ++i) moved += x[i] != y[i];
  EXPECT_LT(moved, set.size / 20);
}

TEST(RoofRansac, TooFewPointsOrNoPlane) {
  EXPECT_TRUE(roof_ransac({}, {{}, 13}, roof_params(1)).planes.empty());
  for (const auto& set : test::point_sets(127)) {
    const auto near = test::neighbours_of(set.view(), 13);
    EXPECT_TRUE(roof_ransac(set.view(), near.lists(), roof_params(1)).planes.empty()) << set.name;
  }
  const auto line = test::point_sets(400)[3];
  const auto near = test::neighbours_of(line.view(), 13);
  EXPECT_TRUE(roof_ransac(line.view(), near.lists(), roof_params(1)).planes.empty());
}

}  // namespace
}  // namespace ilot
