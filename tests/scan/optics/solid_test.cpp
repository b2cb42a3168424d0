// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/solid.h"

#include <gtest/gtest.h>

namespace ilot::scan {
namespace {

// The cube [0, 1]^3: faces x = 1, x = 0, y = 1, y = 0, z = 1, z = 0.
ConvexSolid cube() {
  ConvexSolid solid;
  solid.planes = {Plane{{1, 0, 0}, -1}, Plane{{-1, 0, 0}, 0}, Plane{{0, 1, 0}, -1},
                  Plane{{0, -1, 0}, 0}, Plane{{0, 0, 1}, -1}, Plane{{0, 0, -1}, 0}};
  solid.face_count = 6;
  solid.bounds = {{0, 0, 0}, {1, 1, 1}};
  return solid;
}

TEST(Solid, RaysEnterThroughTheFaceTheyMeetFirst) {
  const auto hit = enter({{0.5, 0.5, 3}, {0, 0, -1}}, cube());
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->face, 4u);
  EXPECT_DOUBLE_EQ(hit->t, 2);
  EXPECT_FALSE(enter({{1.5, 0.5, 3}, {0, 0, -1}}, cube()));   // beside
  EXPECT_FALSE(enter({{0.5, 0.5, 3}, {0, 0, 1}}, cube()));    // away
  EXPECT_FALSE(enter({{0.5, 0.5, 0.5}, {0, 0, 1}}, cube()));  // from inside
}

TEST(Solid, RaysThroughAnEdgeTakeTheSmallerFace) {
  const auto hit = enter({{2, 2, 0.5}, {-0.6, -0.6, 0}}, cube());
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->face, 0u);
}

TEST(Solid, CrownsHaveAChord) {
  const Crown crown{{0, 0, 10}, {2, 2, 4}};
  const auto chord = cross({{0, 0, 20}, {0, 0, -1}}, crown);
  ASSERT_TRUE(chord);
  EXPECT_DOUBLE_EQ(chord->enter, 6);
  EXPECT_DOUBLE_EQ(chord->leave, 14);
  EXPECT_FALSE(cross({{2.01, 0, 20}, {0, 0, -1}}, crown));
}

}  // namespace
}  // namespace ilot::scan
