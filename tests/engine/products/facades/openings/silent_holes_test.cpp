// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/silent_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "engine/products/facades/openings/openings.h"
#include "engine/products/facades/openings/unseen_areas.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr Vec3 kSilentEye{1, 1.5, 8};
constexpr std::uint32_t kNoEcho = 999;
const test::Sheet kSilentWindow{2, 0, 2, 3.1, 1.2, 2.8, 0};

// A wall with a window whose pane gives no echo. Its reveals do.
test::ScannedWall silent_wall() {
  test::ScannedWall wall;
  wall.wall({kSilentWindow});
  for (test::Sheet& s : wall.sheets)
    if (s.axis == 2 && s.at < 0) s.plane = kNoEcho;
  return wall;
}

TEST(SilentHoles, AWindowWithoutAnEchoIsAnOpening) {
  const FacadeSite site = test::scan_wall(silent_wall(), kSilentEye, 0.0025, kNoEcho);
  std::vector<UnseenArea> unseen;
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site), {}, nullptr, &unseen);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].no_echo);
  EXPECT_NEAR(found[0].at(Side::left), 2, found[0].error(Side::left));
  EXPECT_NEAR(found[0].at(Side::right), 3.1, found[0].error(Side::right));
  EXPECT_NEAR(found[0].at(Side::bottom), 1.2, found[0].error(Side::bottom));
  EXPECT_NEAR(found[0].at(Side::top), 2.8, found[0].error(Side::top));
  for (const Side side : kSides) EXPECT_LT(found[0].error(side), 0.03);
  EXPECT_TRUE(unseen.empty());
}

// A sign before the wall that was cut out of the cloud leaves a hole with straight sides, but nothing behind the wall.
TEST(SilentHoles, TheShadowOfWhatWasCutOutIsOnlyAPossibleOpening) {
  test::ScannedWall wall;
  wall.wall({});
  wall.sheets.push_back({2, 1, 2, 3.1, 1.2, 2.8, kNoEcho});
  const FacadeSite site = test::scan_wall(wall, kSilentEye, 0.0025, kNoEcho);
  std::vector<UnseenArea> unseen;
  EXPECT_TRUE(find_openings(RaySamples(site), {}, nullptr, &unseen).empty());
  ASSERT_EQ(unseen.size(), 1u);
  EXPECT_TRUE(unseen[0].straight);
  EXPECT_EQ(unseen[0].ring.size(), 4u);
}

// Where nobody knows from where the wall was scanned, the points on the reveals of a hole show that rays went into it.
TEST(SilentHoles, WithoutStationsItsRevealsShowAnOpening) {
  FacadeSite site = test::scan_wall(silent_wall(), kSilentEye, 0.0025, kNoEcho);
  site.stations.clear(), site.from.clear();
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].no_echo);
  EXPECT_NEAR(found[0].at(Side::left), 2, 0.05);
  EXPECT_NEAR(found[0].at(Side::right), 3.1, 0.05);
  EXPECT_NEAR(found[0].at(Side::bottom), 1.2, 0.05);
  EXPECT_NEAR(found[0].at(Side::top), 2.8, 0.05);
}

TEST(SilentHoles, WithoutStationsAndRevealsItIsOnlyAPossibleOpening) {
  FacadeSite site = test::scan_wall(silent_wall(), kSilentEye, 0.0025, kNoEcho);
  std::erase_if(site.points, [](const FacadePoint& p) { return p.w < -0.02F; });
  site.stations.clear(), site.from.clear();
  std::vector<UnseenArea> unseen;
  EXPECT_TRUE(find_openings(RaySamples(site), {}, nullptr, &unseen).empty());
  ASSERT_EQ(unseen.size(), 1u);
  EXPECT_TRUE(unseen[0].straight);
}

// Something that is in the cloud stands before a window without an echo: none of it was seen.
TEST(SilentHoles, WhatStandsBeforeAHoleStopsItsRays) {
  test::ScannedWall wall = silent_wall();
  wall.sheets.push_back({2, 1, 1.5, 3.3, 0.8, 2.9, 7});
  const FacadeSite site = test::scan_wall(wall, kSilentEye, 0.0025, kNoEcho);
  std::vector<UnseenArea> unseen;
  EXPECT_TRUE(find_openings(RaySamples(site), {}, nullptr, &unseen).empty());
  ASSERT_EQ(unseen.size(), 1u);
  EXPECT_FALSE(unseen[0].straight);
}

// The same far from the wall, where only the source of far points has it.
TEST(SilentHoles, WhatStandsInTheStreetStopsRaysToo) {
  test::ScannedWall wall;
  wall.wall({});
  wall.sheets.push_back({2, 4, 1.5, 2.3, 1.4, 2.2, 7});
  FacadeSite site = test::scan_wall(wall, kSilentEye, 0.0025, kNoEcho), near = site;
  std::erase_if(near.points, [](const FacadePoint& p) { return p.w > 2.5F; });
  near.points.push_back({2.5F, 1.5F, -0.1F, 0});
  const FacadePointSource source = [&](const TakeFacadePoints& take) { take(near.points, {}); };
  const FarPointSource far = [&](std::span<const SpaceBox>, const TakeFacadePoints& take) {
    std::vector<FacadePoint> points;
    for (const FacadePoint& p : site.points)
      if (p.w > 2.5F) points.push_back(p);
    for (int i = 0; i < 100; ++i) points.push_back({0.02F * static_cast<float>(i), 0, 7, 0});  // ground at the station
    take(points, {});
  };
  FacadeSite empty = near;
  empty.points.clear();
  std::vector<UnseenArea> unseen;
  EXPECT_TRUE(find_openings(RaySamples(empty, source, {}, far), {}, nullptr, &unseen).empty());
  EXPECT_EQ(unseen.size(), 1u);
  const FarPointSource ground = [&](std::span<const SpaceBox>, const TakeFacadePoints& take) {
    std::vector<FacadePoint> points;
    for (int i = 0; i < 100; ++i) points.push_back({0.02F * static_cast<float>(i), 0, 7, 0});
    take(points, {});
  };
  EXPECT_EQ(find_openings(RaySamples(empty, source, {}, ground)).size(), 1u);
}

// A wall of which the rays that cross it in `silent` gave no echo, except for one in fifty that ended on a reveal.
FacadeSite wall_silent_where(Vec3 eye, const std::function<bool(double, double)>& silent) {
  test::ScannedWall wall;
  wall.wall({});
  FacadeSite site = test::scan_wall(wall, eye, 0.0025);
  std::vector<FacadePoint> kept;
  std::size_t crossed = 0;
  for (const FacadePoint& p : site.points) {
    if (!silent(p.u, p.v)) {
      kept.push_back(p);
    } else if (++crossed % 50 == 0) {
      const double on = (eye.z + 0.12) / eye.z;
      kept.push_back(
          {static_cast<float>(eye.x + (p.u - eye.x) * on), static_cast<float>(eye.y + (p.v - eye.y) * on), -0.12F, 0});
    }
  }
  site.points = std::move(kept);
  return site;
}

// Two straight sides that meet at a point fill less of their box than a half circle.
TEST(SilentHoles, APointedArchWithoutAnEchoIsAnOpening) {
  const FacadeSite site = wall_silent_where({1, 1.5, 8}, [](double u, double v) {
    return v > 1 && v < 2.8 && std::abs(u - 3) < 0.6 * std::min(1.0, (2.8 - v) / 1.1);
  });
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].no_echo);
  EXPECT_NEAR(found[0].at(Side::bottom), 1, 0.05);
}

// Bars in the plane of the wall leave no wall beside the panes between them: the window shows as a whole that rays
// crossed it.
TEST(SilentHoles, BarsInThePlaneOfTheWallDivideNoWindow) {
  const auto is_bar = [](double u, double v) { return std::abs(v - 2) < 0.03 || std::abs(u - 2.6) < 0.02; };
  const FacadeSite site = wall_silent_where(
      {1, 1.5, 8}, [&](double u, double v) { return u > 2 && u < 3.2 && v > 1.2 && v < 2.8 && !is_bar(u, v); });
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at(Side::left), 2, found[0].error(Side::left));
  EXPECT_NEAR(found[0].at(Side::right), 3.2, found[0].error(Side::right));
  EXPECT_NEAR(found[0].at(Side::bottom), 1.2, found[0].error(Side::bottom));
  EXPECT_NEAR(found[0].at(Side::top), 2.8, found[0].error(Side::top));
}

// The same with a round head.
TEST(SilentHoles, ABarDividesNoArchedWindow) {
  const FacadeSite site = wall_silent_where({3, 1.5, 8}, [](double u, double v) {
    const bool below = v > 0.6 && v <= 2.2 && std::abs(u - 3) < 0.6;
    return (below || (v > 2.2 && std::hypot(u - 3, v - 2.2) < 0.6)) && std::abs(v - 1.4) > 0.03;
  });
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at(Side::bottom), 0.6, 0.05);
  EXPECT_GT(found[0].at(Side::top), 2.6);
}

// What becomes narrower on one side alone is the shadow of something, and no arch.
TEST(SilentHoles, ASlantingHoleIsNoArch) {
  const FacadeSite site = wall_silent_where({1, 1.5, 8}, [](double u, double v) {
    return v > 1 && v < 2.8 && u > 2.4 && u < 2.4 + 1.2 * std::min(1.0, (2.8 - v) / 1.1);
  });
  EXPECT_TRUE(find_openings(RaySamples(site)).empty());
}

TEST(SilentHoles, TheRingOfCellsFollowsTheirBorder) {
  WallCells cells{1, 5, 4, std::vector<std::uint8_t>(20, WallCells::kSolid)};
  WallHole hole;
  hole.region.cells = {6, 7, 12};  // a step: two cells in the second row, one above the right one
  const UnseenArea area = area_of(hole, cells);
  ASSERT_EQ(area.ring.size(), 6u);
  double twice = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Place2 a = area.ring[i], b = area.ring[(i + 1) % 6];
    twice += a.u * b.v - b.u * a.v;
  }
  EXPECT_DOUBLE_EQ(twice, 6);
}

bool is_in_ring(const std::vector<Place2>& ring, Place2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (b.u - a.u) * (p.v - a.v) / (b.v - a.v)) inside = !inside;
  }
  return inside;
}

// A van that was removed from the cloud hid the foot of a window and the wall beside it: the wall is not seen there,
// and the window is not hatched.
TEST(SilentHoles, WhatIsNotSeenEndsAtAnOpening) {
  test::ScannedWall wall;
  wall.wall({{2, -0.25, 2.4, 3.6, 1, 2.8, 0}});
  wall.block(0.8, 3, 0.2, 1.4, 1.2, 998);
  const FacadeSite site = test::scan_wall(wall, {3, 1.2, 8}, 0.0025, 998);
  std::vector<UnseenArea> unseen;
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site), {}, nullptr, &unseen);
  ASSERT_EQ(found.size(), 1u);
  const Box2 box = found[0].box();
  int in_window = 0, beside = 0;
  for (const UnseenArea& area : unseen)
    for (double v = 0.3; v < 2.7; v += 0.1) {
      for (double u = box.u0 + 0.1; u < box.u1 - 0.1; u += 0.1)
        in_window += is_in_ring(area.ring, {u, v}) && v > box.v0 + 0.1;
      for (double u = 0.9; u < box.u0 - 0.1; u += 0.1) beside += is_in_ring(area.ring, {u, v});
    }
  EXPECT_EQ(in_window, 0);
  EXPECT_GT(beside, 50) << "the wall beside the window";
}

// A board beside a large window was cut out of the cloud: less than half of the hole of both is not seen, and it is no
// wall.
TEST(SilentHoles, TheSmallerPartOfAHoleIsHatchedToo) {
  test::ScannedWall wall;
  wall.wall({{2, -0.25, 1.2, 3.6, 0.8, 2.8, 0}});
  wall.sheets.push_back({2, 0.3, 3.5, 4.3, 1.4, 2.4, kNoEcho});
  const FacadeSite site = test::scan_wall(wall, {2.4, 1.5, 8}, 0.0025, kNoEcho);
  std::vector<UnseenArea> unseen;
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site), {}, nullptr, &unseen);
  ASSERT_EQ(found.size(), 1u);
  int beside = 0;
  for (const UnseenArea& area : unseen)
    for (double v = 1.5; v < 2.3; v += 0.1) beside += is_in_ring(area.ring, {3.95, v});
  EXPECT_GT(beside, 5);
}

// The outline was drawn as a rectangle over a wall that was seen up to a slope.
TEST(UnseenAreas, WhatIsAboveTheWallAndInTheOutlineIsHatched) {
  WallCells cells;
  cells.cell = 0.1, cells.columns = 40, cells.rows = 50;
  cells.what.assign(2000, WallCells::kUnknown);
  for (std::int64_t c = 0; c < 40; ++c)
    for (std::int64_t r = 0; r < 50 - c; ++r) cells.at(c, r) = WallCells::kSolid;
  const auto areas = [&](const std::vector<Place2>& outline, const std::vector<Box2>& drawn) {
    return unseen_above_wall(cells, outline, drawn, 0.3);
  };
  const std::vector<Place2> box{{0, 0}, {4, 0}, {4, 5}, {0, 5}}, gable{{0, 0}, {4, 0}, {4, 1}, {0, 5}};
  const std::vector<UnseenArea> above = areas(box, {});
  ASSERT_EQ(above.size(), 1u);
  EXPECT_TRUE(is_in_ring(above[0].ring, {3.55, 4.55}));
  EXPECT_FALSE(is_in_ring(above[0].ring, {0.55, 3.55})) << "the wall";
  EXPECT_TRUE(areas(gable, {}).empty());
  EXPECT_TRUE(areas(box, {{0, 4, 0, 5}}).empty()) << "something is drawn there";
}

}  // namespace
}  // namespace ilot
