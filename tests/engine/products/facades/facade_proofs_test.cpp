// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_proofs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ilot {
namespace {

FoundFacade with_opening(std::vector<std::uint64_t> points_of_edges) {
  FoundFacade found;
  FacadeElement e;
  e.kind = "window";
  e.opening = true;
  e.ring.resize(points_of_edges.size());
  for (const std::uint64_t points : points_of_edges) e.edges.push_back({DrawnStatus::seen, points, 0.001, 0.004, 0});
  found.facade.elements.push_back(e);
  return found;
}

TEST(FacadeProofs, ASideWithoutPointsWasNotSeen) {
  FoundFacade found = with_opening({5, 0, 7, 9});
  mark_bare_sides(found, 0.06);
  const FacadeElement& e = found.facade.elements[0];
  EXPECT_EQ(e.edges[1].status, DrawnStatus::occluded);
  EXPECT_EQ(e.edges[1].error_m, 0.06) << "it is not known better than points would show it";
  EXPECT_EQ(e.edges[0].status, DrawnStatus::seen);
  EXPECT_EQ(e.edges[0].error_m, 0.004);
  EXPECT_EQ(found.occluded_edges, 1u);
  EXPECT_FALSE(e.reason.empty());
}

// The chords of an arch are short: some have no point by chance.
TEST(FacadeProofs, TheChordsOfAHeadAreOneSide) {
  FoundFacade some = with_opening({5, 6, 0, 2, 0, 1, 0, 9}), none = with_opening({5, 6, 0, 0, 0, 0, 0, 9});
  mark_bare_sides(some, 0.06);
  for (const FacadeEdge& edge : some.facade.elements[0].edges) EXPECT_EQ(edge.status, DrawnStatus::seen);
  EXPECT_EQ(some.occluded_edges, 0u);
  mark_bare_sides(none, 0.06);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(none.facade.elements[0].edges[i].status, i < 2 || i == 7 ? DrawnStatus::seen : DrawnStatus::occluded)
        << i;
  EXPECT_EQ(none.occluded_edges, 1u);
}

TEST(FacadeProofs, AnOpeningOfWhichNothingWasSeenIsOccluded) {
  FoundFacade found = with_opening({0, 0, 0, 0});
  mark_bare_sides(found, 0.06);
  EXPECT_EQ(found.facade.elements[0].status, DrawnStatus::occluded);
  EXPECT_EQ(found.occluded_edges, 4u);
}

TEST(FacadeProofs, ASizeIsKnownNoBetterThanASideWithoutPoints) {
  FoundFacade found = with_opening({5, 0, 7, 9});
  mark_bare_sides(found, 0.06);
  EXPECT_NEAR(found.facade.elements[0].width_error_m, std::sqrt(0.06 * 0.06 + 0.004 * 0.004), 1e-12);
}

FacadeElement recess_with(std::vector<double> shares) {
  FacadeElement e;
  e.kind = "recess";
  e.depth_error_m = 0.01;
  e.ring = {{0, 0, 0}, {3, 0, 0}, {3, 0, 1}, {0, 0, 1}};
  for (const double share : shares)
    e.edges.push_back({DrawnStatus::seen, share > 0 ? 9u : 0u, 0.001, 0.004, 0, {}, share});
  return e;
}

TEST(FacadeProofs, ARecessIsSeenOnlyWhereItsSidesAre) {
  FoundFacade found;
  found.facade.elements = {recess_with({0.03, 0, 0.03, 1}), recess_with({0.03, 1, 0.03, 1}),
                           recess_with({1, 0.4, 0.4, 0.4}), recess_with({0, 0, 0, 0})};
  mark_bare_sides(found, 0.06);
  const std::vector<FacadeElement>& e = found.facade.elements;
  EXPECT_EQ(e[0].status, DrawnStatus::completed);
  EXPECT_EQ(e[0].edges[1].status, DrawnStatus::occluded);
  EXPECT_EQ(e[0].edges[0].status, DrawnStatus::seen);
  EXPECT_FALSE(e[0].reason.empty());
  EXPECT_EQ(e[1].status, DrawnStatus::seen) << "two sides";
  EXPECT_EQ(e[2].status, DrawnStatus::seen) << "more than half of it";
  EXPECT_EQ(e[3].status, DrawnStatus::occluded);
}

}  // namespace
}  // namespace ilot
