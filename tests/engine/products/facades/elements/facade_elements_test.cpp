// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/facade_elements.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot {
namespace {

// Under an arch of 0.6 m about (2, 3), with jambs that are known to 2 mm.
FacadeElement arched(double left, double right) {
  FacadeSite site;
  site.axes = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  ElementCandidate candidate;
  const double at[4] = {1, right, 3.6, left};
  for (const Side side : kSides) candidate.shape.side(side) = {at[static_cast<std::size_t>(side)], 0.002};
  candidate.shape.arc = TopArc{{2, 3}, 0.6, 0.001, 0.001, 100};
  return element_of(site, candidate);
}

// One millimetre of the jamb moves the place where it meets the circle by 35.
TEST(FacadeElements, HalfCirclesSpringAtTheirCentre) {
  const FacadeElement e = arched(1.401, 2.602);
  EXPECT_NEAR(e.ring[2].z, 3, 1e-9);
  EXPECT_NEAR(e.ring.back().z, 3, 1e-9);
}

TEST(FacadeElements, FlatterArchesSpringWhereTheyMeetTheJambs) {
  const FacadeElement e = arched(1.5, 2.55);
  EXPECT_NEAR(e.ring[2].z, 3 + std::sqrt(0.36 - 0.55 * 0.55), 1e-9);
  EXPECT_NEAR(e.ring.back().z, 3 + std::sqrt(0.36 - 0.25), 1e-9);
}

}  // namespace
}  // namespace ilot
