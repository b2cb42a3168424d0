// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/pavement_errors.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

PavementWidth stated(double x, double width, double passable, double error) {
  PavementWidth w;
  w.from = {x, 0.02, 0.1}, w.to = {x, 0.02 + width, 0.1};
  w.end = PavementEnd::wall;
  w.width_m = width, w.passable_m = passable, w.error_m = error, w.road_m = 6.1;
  return w;
}

TEST(PavementErrors, WidthsPassablePartsAndTheRoad) {
  Truth truth;
  truth.kerbs = {{{{0, 0, 0.1}, {20, 0, 0.1}}, 0.12}};
  truth.pavements = {{{{0, 0, 0.1}, {10, 0, 0.1}}, 2, 2.4},
                     {{{10, 0, 0.1}, {20, 0, 0.1}}, 2, 0},
                     {{{0, -6, 0.1}, {20, -6, 0.1}}, 2, 0}};
  // A bin from 0.3 to 0.9 m, a hedge behind the pavement, a walker.
  truth.outlines = {{{{2, 0.3, 0}, {3, 0.3, 0}, {3, 0.9, 0}, {2, 0.9, 0}}, false, false},
                    {{{12, 2.1, 0}, {15, 2.1, 0}, {15, 2.5, 0}, {12, 2.5, 0}}, true, false},
                    {{{7, 1, 0}, {8, 1, 0}, {8, 1.5, 0}, {7, 1.5, 0}}, false, true}};
  KerbSight sight(truth.kerbs, 1);
  for (double x = 0; x < 20; x += 0.05)
    for (const double y : {-0.3, -0.2, 0.2, 0.3}) sight.add({x, y, 0});
  const std::vector<PavementWidth> found{stated(2.5, 2.45, 1.55, 0.1), stated(7.5, 2.4, 2.4, 0.1),
                                         stated(13.5, 2.1, 2.1, 0), stated(18.5, 3, 3, 0), stated(40, 2, 2, 0)};
  const PavementResult r = evaluate_pavements(sight, truth, found, 1);
  EXPECT_EQ(r.stated, 5u);
  EXPECT_EQ(r.away, 1u);
  EXPECT_EQ(r.endless, 1u);
  EXPECT_EQ(r.width.count, 3u);
  EXPECT_NEAR(r.width.p95, 0.05, 1e-9);
  EXPECT_EQ(r.passable.count, 2u) << "where somebody walks it is not judged";
  EXPECT_NEAR(r.passable.p95, 0.03, 1e-9) << "the strip begins at the kerb that was found";
  EXPECT_NEAR(r.near, 1, 1e-9);
  EXPECT_NEAR(r.within_stated, 1, 1e-9);
  EXPECT_NEAR(r.road.median, 0.08, 1e-9);
  EXPECT_EQ(r.built, 1u);
  EXPECT_NEAR(r.true_m, 10 + 3.5, 0.8) << "the house and the hedge";
  EXPECT_NEAR(r.complete, 6 / r.true_m, 0.1);
}

}  // namespace
}  // namespace ilot
