// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/facade_sight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/facades.h"

namespace ilot {
namespace {

// A wall with a window of 1 by 2 m, 0.25 m deep. The wall lies in y = 0, the street before it at y < 0.
Facade a_seen_wall() {
  FacadeElement outline = drawn("outline", wall_rectangle(0, 0, 6, 4));
  outline.region = FacadeRegion::facade;
  outline.edges.assign(4, {});
  FacadeElement window = drawn("window", wall_rectangle(1.5, 1, 2.5, 3));
  window.edges.assign(4, {});
  window.depth_m = -0.25;
  for (const char* name : {"front", "right", "left"}) window.faces.push_back({name, 1, 0, {}});
  outline.faces.push_back({"front", 1, 0, {}});
  return facade_of({outline, window});
}

// A screen parallel to the wall, so far before it.
SectionFace screen(double out, double x0, double x1, double z0, double z1) {
  return {{wall_rectangle(x0, z0, x1, z1, -out)}};
}

Facade seen_from(const std::vector<Vec3>& stations, const std::vector<SectionFace>& faces) {
  Facade facade = a_seen_wall();
  measure_sight(stations, LineOfSight(faces), {}, facade);
  return facade;
}

TEST(FacadeSight, TheShadowOfAScreenHidesAKnownPartOfAnEdge) {
  // From 10 m before the wall, a screen half way throws a shadow of twice its size: x 1 to 5, z 0 to 2.
  const Facade facade = seen_from({{3, -10, 2}}, {screen(5, 2, 4, 1, 2)});
  const std::vector<FacadeEdge>& edges = facade.elements[1].edges;
  EXPECT_NEAR(*edges[0].occluded_share, 1, 1e-9) << "bottom, z = 1";
  EXPECT_NEAR(*edges[1].occluded_share, 0.5, 0.021) << "right: its lower half, to a place of 4 cm";
  EXPECT_NEAR(*edges[2].occluded_share, 0, 1e-9) << "top";
  EXPECT_NEAR(*edges[3].occluded_share, 0.5, 0.021);
  const std::vector<FacadeEdge>& outline = facade.elements[0].edges;
  EXPECT_NEAR(*outline[0].occluded_share, 4.0 / 6, 0.02);
  EXPECT_EQ(*outline[1].occluded_share, 0);
  EXPECT_NEAR(*facade.elements[0].faces[0].occluded_share, (4.0 * 2 - 1) / (24 - 2), 0.02) << "of the wall";
}

TEST(FacadeSight, OneStationThatSeesItIsEnough) {
  const SectionFace board = screen(5, 2, 4, 1, 2);
  EXPECT_EQ(*seen_from({{3, -10, 2}, {3, -4, 2}}, {board}).elements[1].edges[0].occluded_share, 0) << "before it";
  EXPECT_EQ(*seen_from({{3, -10, 2}, {3, 10, 2}}, {board}).elements[1].edges[0].occluded_share, 1) << "behind the wall";
}

TEST(FacadeSight, FacesAreSeenFromTheSideTheyLookTo) {
  // From the left at 45 degrees: the right reveal, and of the pane all but a quarter of its width.
  SectionFace wall{{wall_rectangle(0, 0, 6, 4), wall_rectangle(1.5, 1, 2.5, 3)}};
  const Facade facade = seen_from({{1.5 - 500, -500, 2}}, {wall});
  const std::vector<FacadeFace>& faces = facade.elements[1].faces;
  EXPECT_NEAR(*faces[0].occluded_share, 0.25, 0.05) << "front";
  EXPECT_EQ(*faces[1].occluded_share, 0) << "right";
  EXPECT_EQ(*faces[2].occluded_share, 1) << "left";
  for (const FacadeEdge& e : facade.elements[1].edges) EXPECT_EQ(*e.occluded_share, 0);
}

TEST(FacadeSight, ABodyHidesWhatLiesBehindItself) {
  Facade facade = a_seen_wall();
  facade.elements[1].kind = "protrusion";
  facade.elements[1].opening = false;
  facade.elements[1].depth_m = 0.5;
  std::vector<SectionFace> box;  // its sides and its front
  for (const double x : {1.5, 2.5}) box.push_back({{{{x, 0, 1}, {x, -0.5, 1}, {x, -0.5, 3}, {x, 0, 3}}}});
  box.push_back(screen(0.5, 1.5, 2.5, 1, 3));
  measure_sight(std::vector<Vec3>{{-20, -10, 2}}, LineOfSight(box), {}, facade);
  EXPECT_EQ(*facade.elements[1].edges[3].occluded_share, 0) << "the near side";
  EXPECT_EQ(*facade.elements[1].edges[1].occluded_share, 1) << "the far side";
  EXPECT_EQ(*facade.elements[1].faces[0].occluded_share, 0) << "its front";
  EXPECT_EQ(*facade.elements[1].faces[1].occluded_share, 1) << "its right side";
}

TEST(FacadeSight, WithoutStationsNothingIsSaid) {
  const Facade facade = seen_from({}, {screen(5, 2, 4, 1, 2)});
  EXPECT_FALSE(facade.elements[1].edges[0].occluded_share);
  EXPECT_FALSE(facade.elements[1].faces[0].occluded_share);
}

}  // namespace
}  // namespace ilot
