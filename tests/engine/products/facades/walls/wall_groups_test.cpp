// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "tests/support/plain_walls.h"

namespace ilot {
namespace {

// An upright rectangle from `from` along a heading, `off` in front of it.
Segment upright(std::uint32_t id, double heading, double from, double to, double low, double high, double off) {
  const double c = cos_degrees(heading), s = cos_degrees(heading - 90);
  const auto at = [&](double along, double z) { return Vec3{along * c + off * s, along * s - off * c, z}; };
  const Vec3 a = at(from, low), b = at(to, high);
  Segment seg;
  seg.id = id;
  seg.plane.n = {s, -c, 0};
  seg.plane.d = -dot(seg.plane.n, a);
  seg.min = {std::min(a.x, b.x), std::min(a.y, b.y), low};
  seg.max = {std::max(a.x, b.x), std::max(a.y, b.y), high};
  seg.centroid = 0.5 * (a + b);
  seg.area_m2 = (to - from) * (high - low);
  seg.points = static_cast<std::uint64_t>(seg.area_m2 * 1000);
  seg.epsilon_m = 0.007;
  seg.rms_m = 0.002;
  return seg;
}

Segment level(std::uint32_t id) {
  Segment seg = upright(id, 0, 0, 20, 0, 5, 0);
  seg.plane = {{0, 0, 1}, 0};
  return seg;
}

TEST(WallGroups, PiecesOnOnePlaneAreOneFacade) {
  for (const double heading : {0.0, 17.0, 90.0, 163.0}) {
    const std::vector<Segment> segments{upright(1, heading, 0, 15, 4, 13, 0), upright(2, heading, 0, 15, 0, 3.8, 0.004),
                                        upright(3, heading, 2, 3, 5, 5.2, 0.09), level(4)};
    const Vec3 eye{10 * cos_degrees(heading - 90), -10 * cos_degrees(heading), 1.6};
    const auto walls = find_walls(segments, {std::vector<Vec3>{eye}, {}}, {});
    ASSERT_EQ(walls.size(), 1u) << heading;
    EXPECT_EQ(walls[0].segments, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_NEAR(walls[0].width, 15, 0.02) << heading;
    EXPECT_NEAR(walls[0].height, 13, 1e-9);
    ASSERT_EQ(walls[0].parallel.size(), 1u);
    EXPECT_EQ(walls[0].parallel[0].id, 3u);
    const FacadeAxes& axes = walls[0].axes;
    EXPECT_NEAR(norm(cross(axes.right, axes.up) - axes.out), 0, 1e-12);
    EXPECT_GT(dot(eye - axes.origin, axes.out), 0);
    EXPECT_NEAR(axes.up.z, 1, 1e-12);
  }
}

// The ends of an upright rectangle along x.
SegmentEnds ends_of(const Segment& s) {
  const auto end = [&](double x) {
    return EndPlane{{x, s.centroid.y, s.centroid.z}, s.plane.n, s.max.z - s.min.z, 0.0005};
  };
  return {true, true, false, end(s.min.x), end(s.max.x)};
}

TEST(WallGroups, HousesThatStandBackByTwoCentimetresAreFacadesOfTheirOwn) {
  for (const double step : {0.02, 0.03, 0.3}) {
    const std::vector<Segment> segments{upright(1, 0, 0, 8, 0, 9, 0), upright(2, 0, 8, 16, 0, 9, -step),
                                        upright(3, 0, 16, 24, 0, 9, 0),
                                        // Scraps of eaves in the plane of the first house lie over the second one.
                                        upright(4, 0, 9, 15, 8.9, 9, 0)};
    std::vector<SegmentEnds> ends;
    for (std::size_t i = 0; i < 3; ++i) ends.push_back(ends_of(segments[i]));
    ends.emplace_back();
    const auto walls = find_walls(segments, {std::vector<Vec3>{{12, -10, 1}}, {}}, {}, ends);
    ASSERT_EQ(walls.size(), 3u) << step;
    for (const WallGroup& wall : walls) EXPECT_NEAR(wall.width, 8, 1e-6) << step;
  }
}

TEST(WallGroups, PiecesOfOneWallAndItsReliefStayTogether) {
  const std::vector<Segment> segments{upright(1, 0, 0, 8, 0, 9, 0), upright(2, 0, 9, 16, 0, 9, 0.004),
                                      upright(3, 0, 5, 10, 3, 6, 0.8)};  // a bay
  std::vector<SegmentEnds> ends;
  for (const Segment& s : segments) ends.push_back(ends_of(s));
  const auto walls = find_walls(segments, {std::vector<Vec3>{{12, -10, 1}}, {}}, {}, ends);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].segments, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(walls[0].parallel.size(), 1u);
}

// A part of two storeys that stands before its wall is relief of it and a facade; a bay of one storey, a pilaster and
// the poles of a scaffold are relief alone.
TEST(WallGroups, AnAvantCorpsIsReliefAndAFacade) {
  Segment scaffold = upright(5, 0, 24, 28, 0, 9, 0.6);
  scaffold.area_m2 = 9;
  const std::vector<Segment> segments{upright(1, 0, 0, 30, 0, 9, 0), upright(2, 0, 10, 16, 0, 9, 0.4),
                                      upright(3, 0, 2, 6, 3, 6, 0.8), upright(4, 0, 20, 21, 0, 9, 0.2), scaffold};
  std::vector<SegmentEnds> ends;
  for (const Segment& s : segments) ends.push_back(ends_of(s));
  const auto walls = find_walls(segments, {std::vector<Vec3>{{12, -10, 1}}, {}}, {}, ends);
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].segments, std::vector<std::uint32_t>{1});
  EXPECT_EQ(walls[0].parallel.size(), 4u);
  EXPECT_EQ(walls[1].segments, std::vector<std::uint32_t>{2});
  EXPECT_NEAR(walls[1].width, 6, 1e-6);
}

// A ground floor that stands back along most of its wall is a facade too, with windows over half of it. A niche, and a
// van before the wall, are not.
TEST(WallGroups, AStoreyThatStandsBackIsReliefAndAFacade) {
  Segment floor = upright(2, 0, 1, 29, 0, 3, -0.13);
  floor.area_m2 = 0.45 * 28 * 3;
  const std::vector<Segment> segments{upright(1, 0, 0, 30, 0, 12, 0), floor, upright(3, 0, 10, 16, 5, 8, -0.2),
                                      upright(4, 0, 2, 19, 0, 2.5, 1)};
  const auto walls = find_walls(segments, {std::vector<Vec3>{{12, -10, 1}}, {}}, {});
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].parallel.size(), 3u);
  EXPECT_EQ(walls[1].segments, std::vector<std::uint32_t>{2});
}

// Fields that are narrower than a wall, and planes over two pilasters each, which are wide enough to be walls.
TEST(WallGroups, FieldsBetweenPilastersAreOneWall) {
  std::vector<Segment> segments;
  std::vector<SegmentEnds> ends;
  for (std::uint32_t k = 0; k < 5; ++k) {
    segments.push_back(upright(k + 1, 0, 2.1 * k, 2.1 * k + 1.5, 0, 14, 0));
    ends.emplace_back();
  }
  for (std::uint32_t k = 0; k < 2; ++k) {
    Segment pilasters = upright(6 + k, 0, 4.2 * k + 1.5, 4.2 * k + 4.2, 0, 14, 0.17);
    pilasters.area_m2 = 11;
    segments.push_back(pilasters);
    ends.push_back(ends_of(pilasters));
  }
  const auto walls = find_walls(segments, {std::vector<Vec3>{{5, -9, 1.6}}, {}}, {}, ends);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].segments.size(), 5u);
  EXPECT_NEAR(walls[0].width, 9.9, 0.02);
  EXPECT_EQ(walls[0].parallel.size(), 2u);
}

TEST(WallGroups, SetBackWallsAndCornersArePartOfNothing) {
  const std::vector<Segment> segments{upright(1, 0, 0, 15, 0, 13, 0), upright(2, 0, 15.5, 28, 0, 12, 0.2),
                                      upright(3, 90, 0, 10, 0, 13, 0)};
  const auto walls = find_walls(segments, {std::vector<Vec3>{{5, -10, 1}}, {}}, {});
  ASSERT_EQ(walls.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(walls[i].segments, (std::vector<std::uint32_t>{static_cast<std::uint32_t>(i + 1)}));
}

TEST(WallGroups, SmallWallsAreNone) {
  const std::vector<Segment> segments{upright(1, 0, 0, 1.5, 0, 13, 0), upright(2, 90, 0, 8, 0, 1.5, 0)};
  EXPECT_TRUE(find_walls(segments, {}, {}).empty());
  WallParams small;
  small.least_width = small.least_height = 1;
  EXPECT_EQ(find_walls(segments, {}, small).size(), 2u);
}

// Without a station the street is away from the middle of everything.
TEST(WallGroups, TheStreetIsOutside) {
  const std::vector<Segment> segments{upright(1, 0, 0, 10, 0, 5, 0), upright(2, 0, 0, 10, 0, 4.9, -8)};
  const auto walls = find_walls(segments, {{}, {5, 4, 2}}, {});
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_LT(walls[0].axes.out.y, 0);
  EXPECT_GT(walls[1].axes.out.y, 0);
}

// A storey that stands back is a facade of its own, and looks to the same street though all points lie before it.
TEST(WallGroups, StoreysThatStandBack) {
  const std::vector<Segment> segments{upright(1, 0, 0, 15, 0, 5, 0), upright(2, 0, 3, 9, 5.1, 8, -0.12),
                                      upright(3, 0, 3, 4, 5.5, 7, -0.22)};
  const auto walls = find_walls(segments, {{}, {7, 0.001, 3}}, {});
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[1].segments, std::vector<std::uint32_t>{2});
  EXPECT_GT(dot(walls[0].axes.out, walls[1].axes.out), 0.9);
}

// A small piece beside the wall's plane is no part of it, a large one is.
TEST(WallGroups, SmallPiecesMustLieOnTheWall) {
  const auto walls = find_walls(std::vector<Segment>{upright(1, 0, 0, 15, 0, 5, 0), upright(2, 0, 15, 18, 0, 5, 0.02),
                                                     upright(3, 0, 4, 5, 5.1, 5.5, 0.02)},
                                {std::vector<Vec3>{{5, -10, 1}}, {}}, {});
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].segments, (std::vector<std::uint32_t>{1, 2}));
}

TEST(WallGroups, SegmentsInAnyOrder) {
  std::vector<Segment> segments{upright(1, 17, 0, 15, 4, 13, 0), upright(2, 17, 0, 15, 0, 3.8, 0.004),
                                upright(3, 107, 2, 12, 0, 9, 0)};
  const auto before = find_walls(segments, {}, {});
  std::reverse(segments.begin(), segments.end());
  const auto after = find_walls(segments, {}, {});
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].segments, after[i].segments);
    EXPECT_NEAR(norm(before[i].axes.origin - after[i].axes.origin), 0, 1e-9);
  }
}

// Behind the wall and above it: not a pane behind a larger front, not what stands before the wall or in it.
TEST(WallGroups, FrontsInTheRoof) {
  const std::vector<Segment> segments{upright(1, 0, 0, 15, 0, 10, 0),          upright(2, 0, 2, 3.6, 10.8, 12.5, -0.4),
                                      upright(3, 0, 6, 7.6, 10.8, 12.5, -0.4), upright(4, 0, 6.3, 7.3, 11, 12.2, -0.55),
                                      upright(5, 0, 9, 10.6, 10.8, 12.5, 0.6), upright(6, 0, 11, 12, 7, 9, -0.3),
                                      upright(7, 0, 1, 14, 11, 13, -2)};
  const std::vector<Vec3> eyes{{5, -10, 1.6}};
  WallParams params;
  const auto walls = find_walls(segments, {eyes, {}}, params);
  ASSERT_EQ(walls[0].segments, (std::vector<std::uint32_t>{1}));
  const std::vector<WallGroup> wall{walls[0]};
  const auto fronts = find_dormer_fronts(wall[0], wall, segments, params);
  ASSERT_EQ(fronts.size(), 2u);
  EXPECT_EQ(fronts[0].segments, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(fronts[1].segments, (std::vector<std::uint32_t>{3}));
  EXPECT_NEAR(fronts[1].width, 1.6, 1e-9);
  EXPECT_NEAR(fronts[1].height, 1.7, 1e-9);
  EXPECT_NEAR(dot(fronts[1].axes.origin - wall[0].axes.origin, wall[0].axes.out), -0.4, 1e-9);
}

bool same(const WallGroup& a, const WallGroup& b) {
  const auto equal = [](Vec3 p, Vec3 q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  const auto ids = [](const std::vector<ParallelPlane>& planes) {
    std::vector<std::uint32_t> list;
    for (const ParallelPlane& p : planes) list.push_back(p.id);
    return list;
  };
  return equal(a.axes.origin, b.axes.origin) && equal(a.axes.out, b.axes.out) && a.width == b.width &&
         a.height == b.height && a.area_m2 == b.area_m2 && a.points == b.points && a.segments == b.segments &&
         ids(a.parallel) == ids(b.parallel);
}

// Blocks of houses along streets of any heading, with balconies, storeys that stand back, dormers and leaning walls.
std::vector<Segment> town(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Segment> segments;
  const auto add = [&](double heading, Vec3 at, double from, double to, double low, double high, double off) {
    Segment s = upright(static_cast<std::uint32_t>(segments.size() + 1), heading, from, to, low, high, off);
    const double lean = 0.03 * (rng.uniform() - 0.5);
    s.plane.n = (1 / std::sqrt(1 + lean * lean)) * (s.plane.n + Vec3{0, 0, lean});
    s.min = s.min + at, s.max = s.max + at, s.centroid = s.centroid + at;
    s.plane.d = -dot(s.plane.n, s.centroid);
    segments.push_back(s);
  };
  for (int house = 0; house < 60; ++house) {
    const double heading = 360 * rng.uniform(), height = 6 + 12 * rng.uniform(), width = 4 + 20 * rng.uniform();
    const Vec3 at{651000 + 150 * rng.uniform(), 6861000 + 150 * rng.uniform(), 40};
    for (double from = 0; from < width; from += 0.5 + 4 * rng.uniform())
      add(heading, at, from, from + 0.2 + 4 * rng.uniform(), height * rng.uniform() / 2, height, 0.06 * rng.uniform());
    for (int k = 0; k < 6; ++k) {
      const double u = width * rng.uniform(), v = height * rng.uniform();
      add(heading, at, u, u + 0.2 + rng.uniform(), v, v + 0.2, 2 * rng.uniform() - 0.7);
      add(heading, at, u, u + 0.8 + rng.uniform(), height + rng.uniform(), height + 2, -2 * rng.uniform());
    }
  }
  for (int house = 0; house < 10; ++house) {
    const Vec3 at{651000 + 15.0 * house, 6861060, 40};
    add(36 * house, at, 0, 12, 0, 9, 0);
    add(36 * house, at, 3, 8, 0, 8.5, 0.05 + 0.1 * house);   // from 0.15 m on an avant-corps
    add(36 * house, at, 0, 9, 0, 2.5, -0.05 - 0.1 * house);  // from 0.15 m on a storey that stands back
  }
  segments.push_back(level(static_cast<std::uint32_t>(segments.size() + 1)));
  return segments;
}

TEST(WallGroups, TheSameAsAskingAllSegments) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Segment> segments = town(seed);
    for (const bool seen : {true, false}) {
      const std::vector<Vec3> stations =
          seen ? std::vector<Vec3>{{651075, 6861075, 42}, {651010, 6861140, 42}} : std::vector<Vec3>{};
      const Vec3 middle{651075, 6861075, 45};
      const std::vector<WallGroup> walls = find_walls(segments, {stations, middle}, {});
      const std::vector<WallGroup> plain = test::plain_walls::find_walls(segments, stations, middle, {});
      ASSERT_GT(walls.size(), 30u);
      ASSERT_EQ(walls.size(), plain.size());
      std::size_t fronts = 0;
      DormerFronts dormers(walls, segments, {});
      for (std::size_t i = 0; i < walls.size(); ++i) {
        EXPECT_TRUE(same(walls[i], plain[i])) << seed << " " << i;
        const auto of_wall = dormers.of(walls[i]);
        const auto expected = test::plain_walls::find_dormer_fronts(walls[i], walls, segments, {});
        ASSERT_EQ(of_wall.size(), expected.size()) << seed << " " << i;
        for (std::size_t k = 0; k < of_wall.size(); ++k) EXPECT_TRUE(same(of_wall[k], expected[k]));
        fronts += of_wall.size();
      }
      EXPECT_GT(fronts, 20u);
    }
  }
}

// A hundred times the segments: a hundred times the work, and not ten thousand times.
TEST(WallGroups, ACityTakesNoLongerThanItsHouses) {
  std::vector<Segment> segments;
  for (int r = 0; r < 200; ++r)
    for (int c = 0; c < 200; ++c) {
      segments.push_back(upright(static_cast<std::uint32_t>(segments.size() + 1), 0, 0, 8, 0, 9, 0));
      Segment& s = segments.back();
      const Vec3 at{651000.0 + 20 * c, 6861000.0 + 20 * r, 40};
      s.min = s.min + at, s.max = s.max + at, s.centroid = s.centroid + at;
      s.plane.d = -dot(s.plane.n, s.centroid);
    }
  const std::vector<Vec3> stations{{651000, 6861000, 42}};
  EXPECT_EQ(find_walls(segments, {stations, {}}, {}).size(), 40000u);
}

}  // namespace
}  // namespace ilot
