// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/thing_kinds.h"

#include <gtest/gtest.h>

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

TEST(ThingKinds, ADoorGoesDownToTheFootOfTheWall) {
  const FoundRectangle door = rectangle_of({1, 2, 0.1, 2.3}, -0.2), window = rectangle_of({3, 4, 1, 2.3}, -0.2),
                       hatch = rectangle_of({5, 6, 0.1, 0.9}, -0.2);
  const std::vector<FoundRectangle> all{door, window, hatch};
  EXPECT_EQ(kind_of_opening(door, all), FacadeThingKind::door);
  EXPECT_EQ(kind_of_opening(window, all), FacadeThingKind::window);
  EXPECT_EQ(kind_of_opening(hatch, all), FacadeThingKind::window) << "too low for a door";
}

TEST(ThingKinds, OfAHiddenFootTheTopsOfDoorsTell) {
  const FoundRectangle door = rectangle_of({1, 2, 0.1, 2.3}, -0.2);
  FoundRectangle hidden = rectangle_of({3, 4, 1.2, 2.35}, -0.2);
  hidden.side(Side::bottom).status = DrawnStatus::occluded;
  hidden.side(Side::bottom).error = 1.1;
  EXPECT_EQ(kind_of_opening(hidden, {door, hidden}), FacadeThingKind::door);
  EXPECT_EQ(kind_of_opening(hidden, {hidden}), FacadeThingKind::window) << "no door beside it";
  hidden.side(Side::top).at = 2.7;
  EXPECT_EQ(kind_of_opening(hidden, {door, hidden}), FacadeThingKind::window) << "its top is not in line";
  hidden.side(Side::top).at = 2.35;
  hidden.side(Side::bottom).error = 0.2;
  EXPECT_EQ(kind_of_opening(hidden, {door, hidden}), FacadeThingKind::window) << "its foot is known to be too high";
}

TEST(ThingKinds, ReliefIsNamedByWhatIsBesideIt) {
  const std::vector<FoundRectangle> openings{rectangle_of({5, 6, 1, 2.5}, -0.2)};
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 0.9, 1}, 0.08), openings, kWall), FacadeThingKind::sill);
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 2.5, 2.7}, 0.05), openings, kWall), FacadeThingKind::lintel);
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 0.2, 0.3}, 0.08), openings, kWall), FacadeThingKind::bulge)
      << "too far below";
  EXPECT_EQ(kind_of_relief(rectangle_of({5.5, 6.1, 0.9, 1}, 0.08), openings, kWall), FacadeThingKind::bulge)
      << "half as wide";
  EXPECT_EQ(kind_of_relief(rectangle_of({4.9, 6.1, 0.9, 1}, 0.6), openings, kWall), FacadeThingKind::balcony)
      << "far out";
  EXPECT_EQ(kind_of_relief(rectangle_of({8, 8.2, 3, 3.3}, 0.6), openings, kWall), FacadeThingKind::bracket) << "narrow";
  EXPECT_EQ(kind_of_relief(rectangle_of({8, 8.2, 3, 3.3}, 0.1), openings, kWall), FacadeThingKind::bulge);
  EXPECT_EQ(kind_of_relief(rectangle_of({8, 11, 3, 6}, 0.6), openings, kWall), FacadeThingKind::protrusion)
      << "a storey high";
  EXPECT_EQ(kind_of_relief(rectangle_of({1, 19, 3, 3.2}, 0.05), openings, kWall), FacadeThingKind::band);
  EXPECT_EQ(kind_of_relief(rectangle_of({1, 19, 3, 3.2}, 0.6), openings, kWall), FacadeThingKind::balcony);
}

TEST(ThingKinds, AnOpeningHasOneSillAndOneLintel) {
  const auto thing = [](const Box2& box, FacadeThingKind kind) {
    return FacadeThing{rectangle_of(box, 0.05), kind, 0, 0, 0, {}};
  };
  std::vector<FacadeThing> things{
      thing({5.1, 5.9, 0.5, 0.8}, FacadeThingKind::sill), thing({4.9, 6.1, 0.9, 1}, FacadeThingKind::sill),
      thing({5, 6, 2.9, 3}, FacadeThingKind::lintel), thing({4.9, 6.1, 2.5, 2.7}, FacadeThingKind::lintel),
      thing({8.1, 8.9, 0.5, 0.8}, FacadeThingKind::sill)};
  keep_nearest_sills(things);
  EXPECT_EQ(things[0].kind, FacadeThingKind::bulge) << "a panel";
  EXPECT_EQ(things[1].kind, FacadeThingKind::sill);
  EXPECT_EQ(things[2].kind, FacadeThingKind::bulge) << "a hood";
  EXPECT_EQ(things[3].kind, FacadeThingKind::lintel);
  EXPECT_EQ(things[4].kind, FacadeThingKind::sill) << "of another opening";
}

TEST(ThingKinds, WhatIsLargeIsNamedBySizeAndPlace) {
  constexpr double kHeight = 9;
  EXPECT_EQ(kind_of_large(rectangle_of({2, 5, 1, 8}, -0.5), kHeight), FacadeThingKind::recess);
  EXPECT_EQ(kind_of_large(rectangle_of({2, 5, 1, 8}, 0.8), kHeight), FacadeThingKind::protrusion) << "a bay";
  EXPECT_EQ(kind_of_large(rectangle_of({2, 8, 3, 4.2}, 0.8), kHeight), FacadeThingKind::balcony);
  EXPECT_EQ(kind_of_large(rectangle_of({2, 8, 3, 4.2}, 0.2), kHeight), FacadeThingKind::protrusion)
      << "nobody stands on it";
  EXPECT_EQ(kind_of_large(rectangle_of({2, 8, 3, 5}, 0.8), kHeight), FacadeThingKind::protrusion) << "a storey high";
  EXPECT_EQ(kind_of_large(rectangle_of({0, 20, 8.9, 9.4}, 0.5), kHeight), FacadeThingKind::eaves);
}

TEST(ThingKinds, RailsAreThinAndHaveNoOtherName) {
  FacadeThing rail{rectangle_of({2, 8, 4, 4.03}, 0.7), FacadeThingKind::balcony, 0, 0, 0, {}};
  EXPECT_TRUE(is_rail(rail));
  rail.kind = FacadeThingKind::band;
  EXPECT_FALSE(is_rail(rail));
  rail.kind = FacadeThingKind::bulge;
  rail.shape = rectangle_of({2, 2.03, 1, 4}, 0.1);
  EXPECT_TRUE(is_rail(rail)) << "an upright bar";
  rail.shape = rectangle_of({2, 2.06, 1, 4}, 0.1);
  EXPECT_FALSE(is_rail(rail));
}

}  // namespace
}  // namespace ilot
