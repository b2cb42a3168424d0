// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/outside_wall.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

constexpr Box2 kWall{0, 10, 0, 8};

ElementCandidate candidate_of(ElementKind kind, const Box2& box) {
  ElementCandidate c;
  c.kind = kind;
  c.shape.side(Side::left).at = box.u0;
  c.shape.side(Side::right).at = box.u1;
  c.shape.side(Side::bottom).at = box.v0;
  c.shape.side(Side::top).at = box.v1;
  return c;
}

bool stays(ElementKind kind, const Box2& box, double depth = 0.5) {
  std::vector<ElementCandidate> all{candidate_of(kind, box)};
  all[0].shape.depth = depth;
  drop_elements_outside(kWall, 2.5, all);
  return !all.empty();
}

TEST(OutsideWall, ReliefOfANeighbourIsNotDrawn) {
  EXPECT_FALSE(stays(ElementKind::band, {10.4, 12, 3, 3.2}));
  EXPECT_FALSE(stays(ElementKind::bulge, {-0.3, 0.1, 0, 5})) << "most of it is a pipe of the other house";
  EXPECT_TRUE(stays(ElementKind::balcony, {8, 10.4, 3, 4})) << "goes round the corner";
  EXPECT_TRUE(stays(ElementKind::protrusion, {10.02, 11, 2, 8})) << "a tower at the corner";
  EXPECT_FALSE(stays(ElementKind::protrusion, {10.5, 11, 2, 8}));
  EXPECT_TRUE(stays(ElementKind::eaves, {-0.5, 10.5, 8, 8.3}));
  EXPECT_TRUE(stays(ElementKind::window, {10.1, 11, 3, 4})) << "the wall may end too early";
}

TEST(OutsideWall, AWallThatMeetsItsEndIsNoProtrusion) {
  EXPECT_FALSE(stays(ElementKind::protrusion, {9.95, 10.3, 0, 6}, 2.48));
  EXPECT_FALSE(stays(ElementKind::protrusion, {-0.4, 0.01, 0, 11}, 2.5));
  EXPECT_TRUE(stays(ElementKind::protrusion, {9.9, 10.3, 0, 6}, 1.2)) << "it has a front";
  EXPECT_TRUE(stays(ElementKind::protrusion, {8, 10.1, 0, 3}, 2.5)) << "a porch";
}

TEST(OutsideWall, AKerbIsNoReliefOfTheWall) {
  EXPECT_FALSE(stays(ElementKind::balcony, {2, 8, -0.2, -0.05}));
  EXPECT_TRUE(stays(ElementKind::band, {2, 8, -0.2, 0.4}));
  EXPECT_TRUE(stays(ElementKind::recess, {2, 8, -3, -0.05})) << "a storey below";
}

FacadeElement element_of(const char* kind, const std::vector<Vec3>& ring, DrawnStatus status) {
  FacadeElement e;
  e.kind = kind;
  e.status = status;
  e.ring = ring;
  e.edges.assign(ring.size(), FacadeEdge{status, 0, 0, 0.1, 0});
  return e;
}

TEST(OutsideWall, WhatNobodySawEndsWithTheOutline) {
  Facade f;
  f.right = {1, 0, 0}, f.up = {0, 0, 1}, f.out = {0, -1, 0};
  const DrawnStatus hidden = DrawnStatus::occluded;
  f.elements = {
      element_of("outline", {{0, 0, 0}, {10, 0, 0}, {10, 0, 8}, {0, 0, 8}}, DrawnStatus::seen),
      element_of("possible opening", {{9, 0, 1}, {10.07, 0, 1}, {10.07, 0, 2}, {9, 0, 2}}, hidden),
      element_of("not seen", {{10.2, 0, 1}, {11, 0, 1}, {11, 0, 2}, {10.2, 0, 2}}, hidden),
      // Two steps past the left end become none.
      element_of("not seen", {{-0.3, 0, 1}, {1, 0, 1}, {1, 0, 3}, {-0.1, 0, 3}, {-0.1, 0, 2}, {-0.3, 0, 2}}, hidden)};
  cut_unseen_at_outline(f, 1);
  ASSERT_EQ(f.elements.size(), 3u);
  EXPECT_DOUBLE_EQ(f.elements[1].ring[1].x, 10);
  EXPECT_DOUBLE_EQ(f.elements[1].width_m, 1);
  ASSERT_EQ(f.elements[2].ring.size(), 4u);
  EXPECT_EQ(f.elements[2].edges.size(), 4u);
  EXPECT_DOUBLE_EQ(f.elements[2].width_m, 1);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(f.elements[i].id, i + 1);
}

}  // namespace
}  // namespace ilot
