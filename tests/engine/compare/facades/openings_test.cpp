// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/openings.h"

#include <gtest/gtest.h>

#include "tests/support/facades.h"

namespace ilot {
namespace {

TEST(Openings, MatchOneToOneByOverlap) {
  const std::vector<TrueOpening> truth{
      {1, 1, wall_rectangle(0, 0, 2, 2)}, {2, 1, wall_rectangle(4, 0, 6, 2)}, {3, 1, wall_rectangle(8, 0, 10, 2)}};
  const Facade facade = facade_of({drawn("window", wall_rectangle(0, 0, 2, 2)),      // as it is
                                   drawn("door", wall_rectangle(4.1, 0, 6.1, 2)),    // shifted: IoU 3.8 / 4.2
                                   drawn("window", wall_rectangle(4.5, 0, 6.5, 2)),  // the second one there
                                   drawn("window", wall_rectangle(8, 0, 10, 0.9)),   // less than half of it
                                   drawn("window", wall_rectangle(15, 5, 16, 6)),    // invented
                                   drawn("sill", wall_rectangle(8, 0, 10, 2)),       // no opening
                                   drawn("window", wall_rectangle(8, 0, 10, 2), DrawnStatus::occluded)});
  const OpeningResult r = evaluate_openings(truth, std::span(&facade, 1));
  EXPECT_EQ(r.truth, 3u);
  EXPECT_EQ(r.found, 5u);
  EXPECT_EQ(r.matched, 2u);
  EXPECT_EQ(r.invented, 3u);
  EXPECT_NEAR(r.iou_mean, (1 + 3.8 / 4.2) / 2, 1e-12);
  // A shift of 0.1 of the second: the right side lies 0.1 outside, the left one 0.1 inside but for the ends, where the
  // level sides are nearer (0.05 on average over 0.1), and the level ones stick out by 0.1 (0.05 on average).
  const double shifted = (2 * 0.1 + 1.8 * 0.1 + 0.2 * 0.05 + 0.2 * 0.05) / 8;
  EXPECT_NEAR(r.ring_distance_m, shifted / 2, 1e-6);
}

TEST(Openings, ElsewhereInDepthIsElsewhere) {
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(0, 0, 2, 2)}};
  const auto matched = [&](double depth) {
    const Facade facade = facade_of({drawn("window", wall_rectangle(0, 0, 2, 2, depth))});
    return evaluate_openings(truth, std::span(&facade, 1)).matched;
  };
  EXPECT_EQ(matched(0.49), 1u);
  EXPECT_EQ(matched(-0.51), 0u);
}

TEST(Openings, NothingOnEitherSide) {
  const Facade facade = facade_of({drawn("window", wall_rectangle(0, 0, 2, 2))});
  EXPECT_EQ(evaluate_openings({}, std::span(&facade, 1)).invented, 1u);
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(0, 0, 2, 2)}, {2, 1, {{1, 0, 1}, {1, 0, 1}, {1, 0, 1}}}};
  const OpeningResult r = evaluate_openings(truth, {});
  EXPECT_EQ(r.truth, 2u);
  EXPECT_EQ(r.matched, 0u);
  EXPECT_EQ(r.iou_mean, 0);
  EXPECT_EQ(evaluate_openings(truth, std::span(&facade, 1)).matched, 1u);
}

}  // namespace
}  // namespace ilot
