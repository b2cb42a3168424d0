// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_solid.h"

#include <gtest/gtest.h>

#include "tests/support/solids.h"

namespace ilot {
namespace {

const Shape kHouse = box({0, 0, 0}, {9, 9, 9});
Shape hollow(Vec3 low, Vec3 high) {
  return turned(box(low, high));
}

TEST(ValidateSolid, Directions) {
  EXPECT_EQ(codes(turned(kHouse)), Codes{405});
  EXPECT_EQ(codes(with_shells({kHouse, box({1, 1, 1}, {2, 2, 2})})), Codes{405})
      << "an inner shell turns the other way";
}

TEST(ValidateSolid, InnerShells) {
  EXPECT_EQ(codes(with_shells({kHouse, hollow({1, 1, 1}, {2, 2, 2})})), Codes{});
  EXPECT_EQ(codes(with_shells({kHouse, hollow({1, 1, 1}, {2, 2, 2}), hollow({4, 4, 4}, {5, 5, 5})})), Codes{});
  EXPECT_EQ(codes(with_shells({kHouse, hollow({8, 1, 1}, {12, 2, 2})})), Codes{401}) << "through the wall";
  EXPECT_EQ(codes(with_shells({kHouse, hollow({1, 1, 0}, {2, 2, 1})})), Codes{401}) << "on the floor";
  EXPECT_EQ(codes(with_shells({kHouse, hollow({1, 1, 1}, {3, 3, 3}), hollow({2, 2, 2}, {4, 4, 4})})), Codes{401});
  EXPECT_EQ(codes(with_shells({kHouse, hollow({1, 1, 1}, {2, 2, 2}), hollow({2, 1, 1}, {3, 2, 2})})), Codes{401})
      << "side by side";
  EXPECT_EQ(codes(with_shells({kHouse, hollow({1, 1, 1}, {2, 2, 2}), hollow({1, 1, 1}, {2, 2, 2})})), Codes{402});
  EXPECT_EQ(codes(with_shells({kHouse, hollow({11, 1, 1}, {12, 2, 2})})), Codes{403});
  EXPECT_EQ(codes(with_shells({kHouse, hollow({9, 1, 1}, {12, 2, 2})})), Codes{403}) << "on the wall, outside";
}

TEST(ValidateSolid, FaultsOfShellsComeFirst) {
  Shape open = box({0, 0, 0}, {9, 9, 9});
  open.faces.pop_back();
  EXPECT_EQ(codes(with_shells({open, box({1, 1, 1}, {2, 2, 2})})), Codes{302});
}

TEST(ValidateSolid, Composites) {
  const Shape next = box({9, 0, 0}, {12, 9, 9});
  EXPECT_EQ(codes(with_solids({kHouse, next})), Codes{});
  EXPECT_EQ(codes(with_solids({kHouse, box({8, 0, 0}, {12, 9, 9})})), Codes{501});
  EXPECT_EQ(codes(with_solids({kHouse, next, kHouse})), Codes{502});
  EXPECT_EQ(codes(with_solids({kHouse, box({20, 0, 0}, {22, 9, 9})})), Codes{503});
  EXPECT_EQ(codes(with_solids({kHouse, box({9, 9, 0}, {12, 12, 9})})), Codes{503}) << "an edge holds nothing together";
  EXPECT_EQ(codes(with_solids({kHouse, kHouse}, PrimitiveKind::multi_solid)), Codes{}) << "each for itself";
}

TEST(ValidateSolid, Empty) {
  EXPECT_EQ(codes(CityObject{"a", "Building", {}, {{PrimitiveKind::solid, "1", "a", {}}}}), Codes{902});
  EXPECT_EQ(codes(CityObject{"a", "Building", {}, {{PrimitiveKind::solid, "1", "a", {{}}}}}), Codes{902});
  EXPECT_EQ(codes(Shape{}), Codes{902});
}

}  // namespace
}  // namespace ilot
