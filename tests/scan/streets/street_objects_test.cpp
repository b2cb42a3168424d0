// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace ilot::scan {
namespace {

std::map<std::string, int> count_classes(const std::vector<StreetObject>& objects) {
  std::map<std::string, int> counts;
  for (const StreetObject& o : objects) ++counts[name_of(o.artefact_class)];
  return counts;
}

TEST(StreetPlan, HasThirtyBlocksOnTwoKilometres) {
  const Street street = plan_street({});
  ASSERT_EQ(street.blocks.size(), 30u);
  EXPECT_NEAR(street.length, 2000, 120);
  for (std::size_t i = 0; i < street.blocks.size(); ++i) {
    const StreetBlock& block = street.blocks[i];
    EXPECT_EQ(block.id, i + 1);
    EXPECT_GT(block.to - block.from, 40);
    if (i > 0) {
      EXPECT_GT(block.from - street.blocks[i - 1].to, 7);
      const double middle = (block.from + street.blocks[i - 1].to) / 2;
      EXPECT_FALSE(street.on_pavement(middle, 7));
    }
    EXPECT_TRUE(street.on_pavement(block.from + 1, -7));
    EXPECT_FALSE(street.on_pavement(block.from + 1, 3));
  }
  // Houses fill the blocks, wall to wall.
  for (int side : {1, -1}) {
    double length = 0, blocks = 0;
    for (const StreetHouse& house : street.houses)
      if (house.side == side) length += house.to - house.from;
    for (const StreetBlock& block : street.blocks) blocks += block.to - block.from;
    EXPECT_NEAR(length, blocks, 1e-6);
  }
}

TEST(StreetObjects, AreAsManyAsInTheDocument) {
  for (std::uint64_t seed : {0, 1, 2, 3, 4}) {
    StreetParams params;
    params.seed = seed;
    const std::vector<StreetObject> objects = place_objects(plan_street(params));
    ASSERT_EQ(objects.size(), 442u);
    auto counts = count_classes(objects);
    EXPECT_EQ(counts["car"], 67);
    EXPECT_EQ(counts["lamppost"], 33);
    EXPECT_EQ(counts["pedestrian"], 198);
    EXPECT_EQ(counts["other"], 144);
    std::map<std::string, std::set<std::string_view>> variants;
    int touching = 0;
    for (const StreetObject& o : objects) {
      variants[name_of(o.artefact_class)].insert(o.variant);
      touching += !o.touches.empty();
      for (std::uint32_t other : o.touches) EXPECT_EQ(objects[other - 1].touches, std::vector<std::uint32_t>{o.id});
    }
    EXPECT_NEAR(touching / 442.0, 0.15, 0.003);
    for (const auto& [name, names] : variants) EXPECT_GE(names.size(), 5u) << name;
  }
}

TEST(StreetObjects, OnlyPairsThatTouchComeClose) {
  const std::vector<StreetObject> objects = place_objects(plan_street({}));
  for (const StreetObject& a : objects)
    for (const StreetObject& b : objects) {
      if (a.id >= b.id) continue;
      const bool touch = !a.touches.empty() && a.touches[0] == b.id;
      EXPECT_FALSE(closer(a.plan, b.plan, touch ? -1e-6 : kClearance)) << a.variant << " " << b.variant;
      if (touch) {
        EXPECT_TRUE(closer(a.plan, b.plan, 1e-6)) << a.variant << " " << b.variant;
      }
    }
}

TEST(StreetObjects, StandOnTheGroundWhereTheyBelong) {
  StreetParams params;
  params.slope_percent = 8;
  const Street street = plan_street(params);
  for (const StreetObject& o : place_objects(street)) {
    const Vec3 base = o.pose.base;
    EXPECT_NEAR(base.z, street.ground_height(base.x, base.y), 1e-9);
    if (o.artefact_class == ArtefactClass::car) {
      EXPECT_LT(std::abs(base.y), kHalfRoad);
      // Its wheels follow the slope.
      const Vec3 ahead = o.pose.direction({1, 0, 0});
      EXPECT_NEAR(ahead.z / ahead.x, 0.08, 1e-3);
    }
    if (o.artefact_class == ArtefactClass::lamppost) {
      EXPECT_TRUE(street.on_pavement(base.x, base.y));
    }
    EXPECT_LT(std::abs(o.plan.y), kHalfStreet - 0.3);
    EXPECT_GT(std::abs(o.plan.y - params.scanner.lane), 1.2);
  }
}

}  // namespace
}  // namespace ilot::scan
