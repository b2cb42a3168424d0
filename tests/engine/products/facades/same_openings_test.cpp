// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/same_openings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ilot {
namespace {

FacadeElement opening(double x0, double x1, double y, double error, DrawnStatus bottom = DrawnStatus::seen) {
  FacadeElement e;
  e.kind = "window";
  e.opening = true;
  e.region = FacadeRegion::element;
  e.ring = {{x0, y, 1}, {x1, y, 1}, {x1, y, 2}, {x0, y, 2}};
  e.edges.assign(4, {DrawnStatus::seen, 10, 0, error, 0});
  e.edges[0].status = bottom;
  return e;
}

// A facade that faces the street at smaller y, in a plane of its own.
FoundFacade facade(double y, std::vector<FacadeElement> openings) {
  FoundFacade f;
  f.facade.origin = {0, y, 0};
  f.facade.right = {1, 0, 0};
  f.facade.up = {0, 0, 1};
  f.facade.out = {0, -1, 0};
  FacadeElement wall = opening(0, 10, y, 0.01);
  wall.kind = "outline", wall.opening = false, wall.region = FacadeRegion::facade;
  f.facade.elements = {wall};
  for (FacadeElement& e : openings) f.facade.elements.push_back(std::move(e));
  for (std::uint32_t i = 0; i < f.facade.elements.size(); ++i) {
    f.facade.elements[i].id = i + 1;
    for (const FacadeEdge& edge : f.facade.elements[i].edges) f.occluded_edges += edge.status != DrawnStatus::seen;
  }
  return f;
}

TEST(SameOpenings, TheBetterKnownOneOfTwoSheetsStays) {
  std::vector<FoundFacade> found{
      facade(0, {opening(1, 2, 0, 0.05), opening(4, 5, 0, 0.01)}),
      facade(-0.1, {opening(1.1, 2.1, -0.1, 0.02), opening(4, 5.2, -0.1, 0.001, DrawnStatus::occluded),
                    opening(7, 8, -0.1, 0.01)})};
  drop_same_openings(found, 1);
  ASSERT_EQ(found[0].facade.elements.size(), 2u);
  EXPECT_EQ(found[0].facade.elements[1].ring[0].x, 4);
  ASSERT_EQ(found[1].facade.elements.size(), 3u);
  EXPECT_EQ(found[1].facade.elements[1].ring[0].x, 1.1);
  EXPECT_EQ(found[1].facade.elements[2].ring[0].x, 7);
  EXPECT_EQ(found[1].facade.elements[2].id, 3u);
  EXPECT_EQ(found[1].occluded_edges, 0u);
}

TEST(SameOpenings, OtherWallsKeepTheirs) {
  std::vector<FoundFacade> found{facade(0, {opening(1, 2, 0, 0.05)}), facade(-0.5, {opening(1, 2, -0.5, 0.05)}),
                                 facade(0, {opening(1.6, 2.6, 0, 0.05)}), facade(0.1, {opening(1, 2, 0.1, 0.05)})};
  found[3].facade.out = {0, 1, 0};  // the other side of the wall
  drop_same_openings(found, 1);
  for (const FoundFacade& f : found) EXPECT_EQ(f.facade.elements.size(), 2u);
}

// An arch has many chords, but four sides.
FacadeElement arched(double x0, double x1, double y, double error) {
  FacadeElement e = opening(x0, x1, y, error);
  e.ring = {{x0, y, 1}, {x1, y, 1}};
  for (int i = 0; i <= 18; ++i) {
    const double angle = i * 3.14159265358979 / 18;
    e.ring.push_back({(x0 + x1) / 2 + (x1 - x0) / 2 * std::cos(angle), y, 2 + (x1 - x0) / 2 * std::sin(angle)});
  }
  e.edges.assign(e.ring.size(), {DrawnStatus::seen, 10, 0, error, 0});
  for (std::size_t i = 2; i + 1 < e.edges.size(); ++i) e.edges[i].status = DrawnStatus::occluded;
  e.arcs.emplace_back();
  return e;
}

TEST(SameOpenings, AnArchHasFourSides) {
  FacadeElement two_hidden = opening(1, 2, -0.1, 0.01, DrawnStatus::occluded);
  two_hidden.edges[2].status = DrawnStatus::occluded;
  std::vector<FoundFacade> found{facade(0, {arched(1, 2, 0, 0.05)}), facade(-0.1, {two_hidden})};
  found[0].occluded_edges = 1;  // the head of the arch
  drop_same_openings(found, 1);
  EXPECT_EQ(found[0].facade.elements.size(), 2u) << "one hidden side is less than two";
  EXPECT_EQ(found[1].facade.elements.size(), 1u);
  EXPECT_EQ(found[0].occluded_edges, 1u);
  EXPECT_EQ(found[1].occluded_edges, 0u);
  found[1].facade.elements.push_back(opening(1, 2, -0.1, 0.01));
  drop_same_openings(found, 1);
  EXPECT_EQ(found[0].facade.elements.size(), 1u);
  EXPECT_EQ(found[0].occluded_edges, 0u);
}

TEST(SameOpenings, WhatIsLeftIsNoFamilyOfOneAndNoPossibleOpening) {
  FacadeElement possible = opening(1, 2, -0.1, 0.01), apart = opening(6, 9, -0.1, 0.01);
  for (FacadeElement* e : {&possible, &apart}) {
    e->kind = "possible opening", e->opening = false, e->region = FacadeRegion::facade;
    e->status = DrawnStatus::occluded;
  }
  FacadeElement same = opening(4, 5, -0.1, 0.05), other = opening(7, 8, -0.1, 0.05);
  same.family = other.family = 3;
  std::vector<FoundFacade> found{
      facade(0, {opening(0.9, 2.1, 0, 0.01), opening(4, 5, 0, 0.01), opening(6, 6.9, 0, 0.01)}),
      facade(-0.1, {same, other, possible, apart})};
  drop_same_openings(found, 1);
  EXPECT_EQ(found[0].facade.elements.size(), 4u);
  ASSERT_EQ(found[1].facade.elements.size(), 3u);
  EXPECT_EQ(found[1].facade.elements[1].ring[0].x, 7);
  EXPECT_EQ(found[1].facade.elements[1].family, 0u);
  EXPECT_EQ(found[1].facade.elements[2].ring[0].x, 6) << "most of it lies beside what was drawn";
}

// Lengths in CRS units of half a metre: the planes are 0.4 units apart, 0.2 m.
TEST(SameOpenings, DistancesAreInMetres) {
  std::vector<FoundFacade> found{facade(0, {opening(1, 2, 0, 0.05)}), facade(-0.4, {opening(1, 2, -0.4, 0.05)})};
  drop_same_openings(found, 0.5);
  EXPECT_EQ(found[0].facade.elements.size(), 2u);
  EXPECT_EQ(found[1].facade.elements.size(), 1u);
}

}  // namespace
}  // namespace ilot
