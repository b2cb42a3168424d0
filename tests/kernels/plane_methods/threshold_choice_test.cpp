// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/threshold_choice.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

TEST(ThresholdChoice, KneeOfABrokenLine) {
  const std::vector<double> x{0, 1, 2, 3, 4, 5}, y{0, 0.1, 0.2, 0.3, 2.3, 4.3};
  EXPECT_EQ(knee_of(x, y), std::optional<std::size_t>(3));
  const std::vector<double> uneven{0, 1, 1.5, 4, 6, 7}, bent{0, 1, 1.5, 4, 12, 16};
  EXPECT_EQ(knee_of(uneven, bent), std::optional<std::size_t>(3));
}

TEST(ThresholdChoice, StraightLinesAndDentsHaveNoKnee) {
  EXPECT_FALSE(knee_of({}, {}));
  const std::vector<double> x{0, 1, 2, 3}, straight{0, 1, 2, 3}, roof{0, 2, 3, 3.5};
  EXPECT_FALSE(knee_of(x, straight));
  EXPECT_FALSE(knee_of(x, roof));
}

// A wall with noise of 2 and a second surface 20 behind half of it: the set must not take that in.
TEST(ThresholdChoice, DistanceStopsBeforeTheNextSurface) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 500}, {1, 0, 0}, {0, 1, 0}, 60, 60, 10, 2}, 0.1);
  b.add(test::Patch{{5, 5, 480}, {1, 0, 0}, {0, 1, 0}, 60, 30, 10, 2}, 0.1);
  const auto set = b.build();
  const auto all = test::all_of(set.size);
  const auto sweep = choose_distance(set.view(), all, {{0, 0, 1}, -500}, 2, 0.8);
  EXPECT_EQ(sweep.value.size(), 19u);
  EXPECT_TRUE(sweep.found);
  EXPECT_GE(sweep.chosen, 4);
  EXPECT_LE(sweep.chosen, 18);
  const auto none = choose_distance({}, {}, {{0, 0, 1}, -500}, 2, 0.8);
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.chosen, 6);
}

TEST(ThresholdChoice, AngleIsTheLeastMeanSquare) {
  test::OrientedSetBuilder b(2);
  b.add(test::Patch{{0, 0, 500}, {1, 0, 0}, {0, 1, 0}, 40, 40, 10, 2}, 0.2);
  Rng rng(3);
  for (int i = 0; i < 800; ++i) {  // clutter within epsilon with normals of any direction
    const Vec3 n{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
    b.add({400 * rng.uniform(), 400 * rng.uniform(), 490 + 20 * rng.uniform()}, (1 / norm(n)) * n);
  }
  const auto set = b.build();
  const auto sweep = choose_angle(set.view(), test::all_of(set.size), {{0, 0, 1}, -500}, 12);
  ASSERT_TRUE(sweep.found);
  EXPECT_LT(sweep.chosen, 40);
  EXPECT_GE(sweep.chosen, 10);
  for (std::size_t i = 0; i < sweep.value.size(); ++i)
    EXPECT_GE(sweep.mse[i], sweep.mse[static_cast<std::size_t>((sweep.chosen - 10) / 2.5)]);
  EXPECT_EQ(choose_angle({}, {}, {}, 1).chosen, 40);
}

}  // namespace
}  // namespace ilot
