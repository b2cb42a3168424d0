// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/facade_sides.h"

#include <gtest/gtest.h>

#include "tests/support/facades.h"

namespace ilot {
namespace {

Facade wall_with_outline() {
  return facade_of({drawn("outline", wall_rectangle(0, 0, 10, 8))});
}

TEST(FacadeSides, AFacadeThatLooksInwardsIsMirrored) {
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(1, 1, 2, 3)}, {2, 1, wall_rectangle(4, 1, 5, 3)}};
  Facade right = wall_with_outline(), wrong = wall_with_outline();
  wrong.right = {-1, 0, 0}, wrong.out = {0, 1, 0};
  const std::vector<Facade> facades{right, wrong};
  const FacadeSides sides = evaluate_facade_sides(truth, facades);
  EXPECT_EQ(sides.judged, 2u);
  EXPECT_EQ(sides.mirrored, 1u);
}

TEST(FacadeSides, OpeningsElsewhereDoNotJudge) {
  const Facade facade = wall_with_outline();
  const auto judged = [&](Ring3 ring) {
    return evaluate_facade_sides(std::vector<TrueOpening>{{1, 1, std::move(ring)}}, std::span(&facade, 1)).judged;
  };
  EXPECT_EQ(judged(wall_rectangle(1, 1, 2, 3, 0.4)), 1u);
  EXPECT_EQ(judged(wall_rectangle(1, 1, 2, 3, 0.6)), 0u);               // behind the wall
  EXPECT_EQ(judged(wall_rectangle(12, 1, 13, 3)), 0u);                  // beside it
  EXPECT_EQ(judged({{1, 0, 1}, {1, 1, 1}, {1, 1, 2}, {1, 0, 2}}), 0u);  // across
  EXPECT_EQ(judged({}), 0u);
}

}  // namespace
}  // namespace ilot
