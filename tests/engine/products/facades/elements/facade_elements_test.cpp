// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/facade_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

// A window of 1 m x 2 m whose sides are known to 3, 4, 12 and 5 mm.
ElementCandidate plain() {
  ElementCandidate candidate;
  const double at[4] = {1, 3, 3, 2}, error[4] = {0.003, 0.004, 0.012, 0.005};
  for (const Side side : kSides) {
    const auto i = static_cast<std::size_t>(side);
    candidate.shape.side(side) = {at[i], error[i]};
  }
  return candidate;
}

FacadeSite site_with(std::size_t stations) {
  FacadeSite site;
  site.axes = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  site.stations.resize(stations);
  return site;
}

void expect_sizes_of_edges(const FacadeElement& e) {
  const auto both = [](double a, double b) { return std::sqrt(a * a + b * b); };
  EXPECT_NEAR(e.width_error_m, both(e.edges[1].error_m, e.edges.back().error_m), 1e-12);
  EXPECT_NEAR(e.height_error_m, both(e.edges[0].error_m, e.edges[2].error_m), 1e-12);
}

TEST(FacadeElements, SizesAreKnownAsWellAsTheEdgesTheyLieBetween) {
  ElementCandidate candidate = plain();
  candidate.shape.side(Side::bottom).form = 0.731;
  std::vector<FacadeElement> elements{element_of(site_with(0), candidate)};
  EXPECT_EQ(elements[0].edges[0].error_m, 0.731);
  expect_sizes_of_edges(elements[0]);
  add_registration(0.01, elements);
  EXPECT_GT(elements[0].edges[0].error_m, 0.731);
  expect_sizes_of_edges(elements[0]);
}

TEST(FacadeElements, ASizeFromAnEdgeDrawnByHandHasNoError) {
  FacadeElement e = element_of(site_with(0), plain());
  e.edges[1] = {};
  e.edges[1].status = DrawnStatus::by_hand;
  state_size_errors(e);
  EXPECT_EQ(e.width_error_m, 0);
  EXPECT_GT(e.height_error_m, 0);
}

TEST(FacadeElements, NothingIsSaidOfRaysWhereNoStationIsKnown) {
  UnseenArea area;
  area.ring = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(unseen_of(site_with(0), area).reason, "no points there");
  EXPECT_EQ(unseen_of(site_with(1), area).reason, "no ray reached it");
}

TEST(FacadeElements, AnOpeningWithADepthGaveEchoes) {
  ElementCandidate candidate = plain();
  candidate.shape.no_echo = true;
  EXPECT_EQ(element_of(site_with(1), candidate).reason, "no echo came back through it");
  EXPECT_EQ(element_of(site_with(0), candidate).reason, "no points in it");
  candidate.shape.points = 3347;
  candidate.shape.depth = -0.05;
  EXPECT_EQ(element_of(site_with(1), candidate).reason, "no echo came back through a part of it");
  EXPECT_EQ(element_of(site_with(0), candidate).reason, "a part of it has no points");
}

}  // namespace
}  // namespace ilot
