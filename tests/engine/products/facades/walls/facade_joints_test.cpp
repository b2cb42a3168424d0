// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/facade_joints.h"

#include <gtest/gtest.h>

#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "tests/support/plain_joints.h"

namespace ilot {
namespace {

// A wall from a place along a heading, its outline short of its ends by `short_by`.
Facade wall(std::uint32_t id, Vec3 from, double heading, double length, double height, double short_by) {
  Facade f;
  f.id = id;
  const double c = cos_degrees(heading), s = cos_degrees(heading - 90);
  f.right = {c, s, 0};
  f.up = {0, 0, 1};
  f.out = {s, -c, 0};
  f.origin = from + short_by * f.right;
  f.width_m = length - 2 * short_by;
  f.height_m = height;
  FacadeElement e;
  e.id = 1;
  e.kind = "outline";
  e.region = FacadeRegion::facade;
  const Vec3 a = f.origin, b = a + f.width_m * f.right, up = height * f.up;
  e.ring = {a, b, b + up, a + up};
  e.width_m = f.width_m;
  e.height_m = height;
  f.elements = {e};
  return f;
}

TEST(FacadeJoints, FourWallsCloseAtTheirCorners) {
  for (const double turn : {0.0, 31.0}) {
    std::vector<Facade> house;
    Vec3 from{651000, 661000, 40};
    const double lengths[4] = {10, 6, 10, 6};
    for (std::uint32_t i = 0; i < 4; ++i) {
      house.push_back(wall(i + 1, from, turn + 90 * i, lengths[i], 5 + 0.01 * i, i % 2 == 0 ? 0.07 : -0.05));
      const double h = turn + 90 * i;
      from = from + lengths[i] * Vec3{cos_degrees(h), cos_degrees(h - 90), 0};
    }
    close_corners(house);
    for (std::size_t i = 0; i < 4; ++i) {
      const FacadeElement &own = house[i].elements[0], &next = house[(i + 1) % 4].elements[0];
      EXPECT_LT(norm(own.ring[1] - next.ring[0]), 1e-6) << i;
      EXPECT_LT(norm(own.ring[2] - next.ring[3]), 1e-6) << i;
      EXPECT_NEAR(house[i].width_m, lengths[i], 1e-6) << i;
      EXPECT_LT(norm(house[i].origin - own.ring[0]), 1e-6) << i;
    }
  }
}

TEST(FacadeJoints, WallsThatDoNotMeetStayAsTheyAre) {
  std::vector<Facade> walls{wall(1, {0, 0, 0}, 0, 10, 5, 0), wall(2, {10.8, 0, 0}, 90, 6, 5, 0),
                            wall(3, {10, 0, 8}, 90, 6, 5, 0),
                            wall(4, {-6 * cos_degrees(4), -6 * cos_degrees(86), 0}, 4, 6, 5, 0)};
  const std::vector<Facade> before = walls;
  close_corners(walls);
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_LT(norm(walls[i].elements[0].ring[k] - before[i].elements[0].ring[k]), 1e-9) << i << " " << k;
}

TEST(FacadeJoints, AStoreyThatStandsBackIsARecessOfTheLargerWall) {
  std::vector<Facade> walls{wall(1, {0, 0, 2}, 0, 10, 6, 0), wall(2, {0, 1.5, 0}, 0, 10, 1.95, 0),
                            wall(3, {0, 20, 0}, 0, 10, 1.95, 0), wall(4, {0, 0, 0}, 180, 10, 1.95, 0)};
  add_storey_steps(walls);
  ASSERT_EQ(walls[0].elements.size(), 2u);
  const FacadeElement& step = walls[0].elements[1];
  EXPECT_EQ(step.kind, "recess");
  EXPECT_EQ(step.id, 2u);
  EXPECT_NEAR(step.depth_m, -1.5, 1e-9);
  EXPECT_NEAR(step.width_m, 10, 1e-9);
  EXPECT_NEAR(step.height_m, 1.95, 1e-9);
  EXPECT_NEAR(step.ring[0].y, 0, 1e-9);
  EXPECT_TRUE(step.body.closed);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(walls[i].elements.size(), 1u);
}

TEST(FacadeJoints, AStoreyThatStandsOutIsAProtrusion) {
  std::vector<Facade> walls{wall(1, {0, 0, 0}, 0, 10, 6, 0), wall(2, {2, -0.8, 6.1}, 0, 5, 2, 0)};
  add_storey_steps(walls);
  ASSERT_EQ(walls[0].elements.size(), 2u);
  EXPECT_EQ(walls[0].elements[1].kind, "protrusion");
  EXPECT_NEAR(walls[0].elements[1].depth_m, 0.8, 1e-9);
}

// Streets of houses whose walls nearly meet, some with a storey that stands back: against asking all others.
TEST(FacadeJoints, TheSameAsAskingAllFacades) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Rng rng(seed);
    std::vector<Facade> facades;
    for (int house = 0; house < 40; ++house) {
      Vec3 from{651000 + 120 * rng.uniform(), 6861000 + 120 * rng.uniform(), 40 + rng.uniform()};
      const double turn = 360 * rng.uniform(), height = 5 + 5 * rng.uniform();
      for (std::uint32_t i = 0; i < 4; ++i) {
        const double h = turn + 90 * i, length = i % 2 == 0 ? 10 : 6;
        const double high = height + 0.3 * rng.uniform(), back = 0.1 + 2 * rng.uniform();
        facades.push_back(wall(1, from, h, length, high, 0.5 * rng.uniform() - 0.25));
        Facade& f = facades.back();
        const Vec3 above = from + Vec3{0, 0, high} - back * f.out;
        if (house % 3 == 0) facades.push_back(wall(1, above, h + 3 * rng.uniform(), length - 1, 3, 0.1));
        from = from + length * Vec3{cos_degrees(h), cos_degrees(h - 90), 0};
      }
    }
    std::vector<Facade> plain = facades;
    close_corners(facades);
    add_storey_steps(facades);
    test::plain_joints::close_corners(plain, {});
    test::plain_joints::add_storey_steps(plain, {});
    std::size_t steps = 0, moved = 0;
    for (std::size_t i = 0; i < facades.size(); ++i) {
      ASSERT_EQ(facades[i].elements.size(), plain[i].elements.size()) << seed << " " << i;
      steps += facades[i].elements.size() - 1;
      for (std::size_t e = 0; e < plain[i].elements.size(); ++e) {
        const std::vector<Vec3>&ring = facades[i].elements[e].ring, &expected = plain[i].elements[e].ring;
        ASSERT_EQ(ring.size(), expected.size());
        for (std::size_t c = 0; c < ring.size(); ++c) EXPECT_EQ(norm(ring[c] - expected[c]), 0) << seed << " " << i;
      }
      moved += facades[i].width_m != 10;
    }
    EXPECT_GT(steps, 20u);
    EXPECT_GT(moved, 100u);
  }
}

}  // namespace
}  // namespace ilot
