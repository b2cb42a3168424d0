// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/ring_relations.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

using Rings = std::vector<std::vector<Point2>>;
const std::vector<Point2> kOuter{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, kHole{{20, 20}, {20, 40}, {40, 40}, {40, 20}};

TEST(RingRelations, SeparatesValidFromInvalid) {
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, kHole}), 0);
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, {{0, 0}, {20, 40}, {40, 20}}}), 0) << "touching in a point";
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, {{80, 20}, {80, 40}, {120, 40}, {120, 20}}}), 201);
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, {{0, 20}, {0, 40}, {40, 40}, {40, 20}}}), 201) << "along an edge";
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, {{0, 50}, {50, 100}, {100, 50}, {50, 0}}}), 205);
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, {{120, 20}, {120, 40}, {140, 40}, {140, 20}}}), 206);
  EXPECT_EQ(ring_relation_fault(Rings{kOuter, {{10, 10}, {10, 90}, {90, 90}, {90, 10}}, kHole}), 207);
}

}  // namespace
}  // namespace ilot
