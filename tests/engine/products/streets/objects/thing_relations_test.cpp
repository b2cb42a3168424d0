// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/thing_relations.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

double get(const Thing& t, ThingFeature f) {
  return t.features[static_cast<std::size_t>(f)];
}

Thing thing(double area, double length, double width, double top, double mean) {
  Thing t;
  t.features[static_cast<std::size_t>(ComponentFeature::area)] = area;
  t.features[static_cast<std::size_t>(ComponentFeature::max_height)] = top;
  t.features[static_cast<std::size_t>(ComponentFeature::mean_height)] = mean;
  t.features[static_cast<std::size_t>(ThingFeature::length)] = length;
  t.features[static_cast<std::size_t>(ThingFeature::width)] = width;
  return t;
}

TEST(ThingRelations, TwoBesideWhatJoinsThem) {
  std::vector<Thing> things{thing(1, 1, 1, 2, 1), thing(3, 3, 1, 1.5, 0.75), thing(4, 4, 2, 2, 0.8)};
  things[2].parts[0] = 1, things[2].parts[1] = 2;
  relate_things(things);
  const Thing &a = things[0], &b = things[1], &both = things[2];
  EXPECT_DOUBLE_EQ(get(both, ThingFeature::fill), 0.5);
  EXPECT_DOUBLE_EQ(get(both, ThingFeature::lesser_share), 0.25);
  EXPECT_DOUBLE_EQ(get(both, ThingFeature::top_step), 0.5);
  EXPECT_DOUBLE_EQ(get(both, ThingFeature::mean_step), 0.25);
  EXPECT_DOUBLE_EQ(get(both, ThingFeature::joined_share), 1);
  EXPECT_DOUBLE_EQ(get(both, ThingFeature::joined_length), 4);
  EXPECT_DOUBLE_EQ(get(a, ThingFeature::lesser_share), 0);
  EXPECT_DOUBLE_EQ(get(a, ThingFeature::joined_share), 0.25);
  EXPECT_DOUBLE_EQ(get(b, ThingFeature::joined_share), 0.75);
  EXPECT_DOUBLE_EQ(get(a, ThingFeature::rise), 0.5);
  EXPECT_DOUBLE_EQ(get(b, ThingFeature::rise), -0.5);
  EXPECT_DOUBLE_EQ(get(a, ThingFeature::joined_fill), 0.5);
  EXPECT_DOUBLE_EQ(get(b, ThingFeature::joined_length), 4);
}

TEST(ThingRelations, WhatStandsAlone) {
  std::vector<Thing> things{thing(1, 2, 1, 2, 1), Thing{}};
  relate_things(things);
  EXPECT_DOUBLE_EQ(get(things[0], ThingFeature::fill), 0.5);
  EXPECT_DOUBLE_EQ(get(things[0], ThingFeature::joined_fill), 0.5);
  EXPECT_DOUBLE_EQ(get(things[0], ThingFeature::joined_share), 1);
  EXPECT_DOUBLE_EQ(get(things[0], ThingFeature::rise), 0);
  EXPECT_DOUBLE_EQ(get(things[1], ThingFeature::fill), 0);
  relate_things({});
}

}  // namespace
}  // namespace ilot
