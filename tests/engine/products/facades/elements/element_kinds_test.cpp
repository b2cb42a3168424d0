// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/element_kinds.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

constexpr double kWall = 20;  // metres wide

FoundRectangle rectangle_of(const Box2& box, double depth) {
  FoundRectangle r;
  r.side(Side::left).at = box.u0;
  r.side(Side::right).at = box.u1;
  r.side(Side::bottom).at = box.v0;
  r.side(Side::top).at = box.v1;
  r.depth = depth;
  return r;
}

TEST(ElementKinds, ADoorGoesDownToTheFootOfTheWall) {
  const FoundRectangle door = rectangle_of({1, 2, 0.1, 2.3}, -0.2), window = rectangle_of({3, 4, 1, 2.3}, -0.2),
                       hatch = rectangle_of({5, 6, 0.1, 0.9}, -0.2);
  const std::vector<FoundRectangle> all{door, window, hatch};
  EXPECT_EQ(kind_of_opening(door, all), ElementKind::door);
  EXPECT_EQ(kind_of_opening(window, all), ElementKind::window);
  EXPECT_EQ(kind_of_opening(hatch, all), ElementKind::window) << "too low for a door";
}

TEST(ElementKinds, SizesAreParameters) {
  const FoundRectangle gate = rectangle_of({1, 2, 0.1, 1.5}, -0.2), canopy = rectangle_of({3, 4, 3, 3.3}, 0.25);
  ElementKindParams params;
  params.door_height = 1.2;
  params.balcony_depth = 0.2;
  params.balcony_width = 1.5;
  EXPECT_EQ(kind_of_opening(gate, {gate}), ElementKind::window);
  EXPECT_EQ(kind_of_opening(gate, {gate}, params), ElementKind::door);
  EXPECT_EQ(kind_of_relief(canopy, {}, 20), ElementKind::bulge);
  EXPECT_EQ(kind_of_relief(canopy, {}, 20, params), ElementKind::bracket);
}

TEST(ElementKinds, ADoorWithAHiddenFootIsKnownByItsTop) {
  const FoundRectangle door = rectangle_of({1, 2, 0.1, 2.3}, -0.2);
  FoundRectangle hidden = rectangle_of({3, 4, 1.2, 2.35}, -0.2);
  hidden.side(Side::bottom).status = DrawnStatus::occluded;
  hidden.side(Side::bottom).error = 1.1;
  EXPECT_EQ(kind_of_opening(hidden, {door, hidden}), ElementKind::door);
  EXPECT_EQ(kind_of_opening(hidden, {hidden}), ElementKind::window) << "no door beside it";
  hidden.side(Side::top).at = 2.7;
  EXPECT_EQ(kind_of_opening(hidden, {door, hidden}), ElementKind::window) << "its top is not in line";
  hidden.side(Side::top).at = 2.35;
  hidden.side(Side::bottom).error = 0.2;
  EXPECT_EQ(kind_of_opening(hidden, {door, hidden}), ElementKind::window) << "its foot is known to be too high";
}

TEST(ElementKinds, ReliefIsNamedByWhatIsBesideIt) {
  const std::vector<FoundRectangle> openings{rectangle_of({5, 6, 1, 2.5}, -0.2)};
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 0.9, 1}, 0.08), openings, kWall), ElementKind::sill);
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 2.5, 2.7}, 0.05), openings, kWall), ElementKind::lintel);
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 0.2, 0.3}, 0.08), openings, kWall), ElementKind::bulge)
      << "too far below";
  EXPECT_EQ(kind_of_relief(rectangle_of({5.5, 6.1, 0.9, 1}, 0.08), openings, kWall), ElementKind::bulge)
      << "half as wide";
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 0.9, 1}, 0.6), openings, kWall), ElementKind::balcony) << "far out";
  EXPECT_EQ(kind_of_relief(rectangle_of({8, 8.2, 3, 3.3}, 0.6), openings, kWall), ElementKind::bracket) << "narrow";
  EXPECT_EQ(kind_of_relief(rectangle_of({8, 8.2, 3, 3.3}, 0.1), openings, kWall), ElementKind::bulge);
  EXPECT_EQ(kind_of_relief(rectangle_of({8, 11, 3, 6}, 0.6), openings, kWall), ElementKind::protrusion)
      << "a storey high";
  EXPECT_EQ(kind_of_relief(rectangle_of({1, 19, 3, 3.2}, 0.05), openings, kWall), ElementKind::band);
  EXPECT_EQ(kind_of_relief(rectangle_of({1, 19, 3, 3.2}, 0.6), openings, kWall), ElementKind::balcony);
}

TEST(ElementKinds, AnOpeningHasOneSillAndOneLintel) {
  const auto candidate = [](const Box2& box, ElementKind kind) {
    return ElementCandidate{rectangle_of(box, 0.05), kind, 0, 0, 0, {}};
  };
  std::vector<ElementCandidate> candidates{
      candidate({5.1, 5.9, 0.5, 0.8}, ElementKind::sill), candidate({4.9, 6.1, 0.9, 1}, ElementKind::sill),
      candidate({5, 6, 2.9, 3}, ElementKind::lintel), candidate({4.9, 6.1, 2.5, 2.7}, ElementKind::lintel),
      candidate({8.1, 8.9, 0.5, 0.8}, ElementKind::sill)};
  keep_nearest_sills(candidates);
  EXPECT_EQ(candidates[0].kind, ElementKind::bulge) << "a panel";
  EXPECT_EQ(candidates[1].kind, ElementKind::sill);
  EXPECT_EQ(candidates[2].kind, ElementKind::bulge) << "a hood";
  EXPECT_EQ(candidates[3].kind, ElementKind::lintel);
  EXPECT_EQ(candidates[4].kind, ElementKind::sill) << "of another opening";
}

TEST(ElementKinds, WhatIsLargeIsNamedBySizeAndPlace) {
  constexpr double kHeight = 9;
  EXPECT_EQ(kind_of_large(rectangle_of({2, 5, 1, 8}, -0.5), kHeight), ElementKind::recess);
  EXPECT_EQ(kind_of_large(rectangle_of({2, 5, 1, 8}, 0.8), kHeight), ElementKind::protrusion) << "a bay";
  EXPECT_EQ(kind_of_large(rectangle_of({2, 8, 3, 4.2}, 0.8), kHeight), ElementKind::balcony);
  EXPECT_EQ(kind_of_large(rectangle_of({2, 8, 3, 4.2}, 0.2), kHeight), ElementKind::protrusion)
      << "nobody stands on it";
  EXPECT_EQ(kind_of_large(rectangle_of({2, 8, 3, 5}, 0.8), kHeight), ElementKind::protrusion) << "a storey high";
  EXPECT_EQ(kind_of_large(rectangle_of({0, 20, 8.9, 9.4}, 0.5), kHeight), ElementKind::eaves);
}

TEST(ElementKinds, RailsAreThinAndHaveNoOtherName) {
  ElementCandidate rail{rectangle_of({2, 8, 4, 4.03}, 0.7), ElementKind::balcony, 0, 0, 0, {}};
  EXPECT_TRUE(is_rail(rail));
  rail.kind = ElementKind::band;
  EXPECT_FALSE(is_rail(rail));
  rail.kind = ElementKind::bulge;
  rail.shape = rectangle_of({2, 2.03, 1, 4}, 0.1);
  EXPECT_TRUE(is_rail(rail)) << "an upright bar";
  rail.shape = rectangle_of({2, 2.06, 1, 4}, 0.1);
  EXPECT_FALSE(is_rail(rail));
}

ElementCandidate opening_between(double u0, double u1, double v0, double v1) {
  ElementCandidate t;
  t.shape.side(Side::left).at = u0, t.shape.side(Side::right).at = u1;
  t.shape.side(Side::bottom).at = v0, t.shape.side(Side::top).at = v1;
  return t;
}

std::vector<double> lefts_of_kept(std::vector<ElementCandidate> candidates) {
  drop_openings_within(candidates);
  std::vector<double> lefts;
  for (const ElementCandidate& t : candidates) lefts.push_back(t.shape.at(Side::left));
  return lefts;
}

// The first lies mostly in the second, the second mostly in the third, but the first not in the third.
TEST(OpeningsWithin, WhatLiesInADroppedOneStays) {
  const ElementCandidate a = opening_between(0, 1, 0, 1), b = opening_between(0.3, 1.5, 0, 1),
                         c = opening_between(0.7, 2.5, 0, 1);
  EXPECT_EQ(lefts_of_kept({a, b, c}), (std::vector<double>{0, 0.7}));
  EXPECT_EQ(lefts_of_kept({c, b, a}), (std::vector<double>{0.7, 0}));
}

TEST(OpeningsWithin, OfTwoOfOneSizeTheEarlierOneStays) {
  const ElementCandidate a = opening_between(0, 1, 0, 1), b = opening_between(0.25, 1.25, 0, 1);
  EXPECT_EQ(lefts_of_kept({a, b}), (std::vector<double>{0}));
  EXPECT_EQ(lefts_of_kept({b, a}), (std::vector<double>{0.25}));
}

TEST(OpeningsWithin, APossibleOneGivesWayToASmallerOne) {
  ElementCandidate possible = opening_between(0, 2, 0, 1);
  possible.possible = true;
  EXPECT_EQ(lefts_of_kept({possible, opening_between(0.5, 1.75, 0, 1)}), (std::vector<double>{0.5}));
  EXPECT_EQ(lefts_of_kept({possible, opening_between(1.5, 2.25, 0, 1)}), (std::vector<double>{0, 1.5}));
}

TEST(OpeningsWithin, OthersThanOpeningsStay) {
  ElementCandidate sill = opening_between(0.2, 0.8, 0, 0.1);
  sill.kind = ElementKind::sill;
  EXPECT_EQ(lefts_of_kept({opening_between(0, 1, 0, 1), sill}).size(), 2u);
}

}  // namespace
}  // namespace ilot
