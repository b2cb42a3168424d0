// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

using Height = std::function<double(double)>;

double gable_top(double u) {
  return 3 + 0.6 * (3 - std::abs(u - 3));
}

// The outermost points of a wall, column by column: what the boundary of its points looks like.
OutlineRing ring_of(const FacadeSite& site) {
  const auto columns = static_cast<std::size_t>(site.width / site.step);
  std::vector<Place2> low(columns, {0, INFINITY}), high(columns, {0, -INFINITY});
  for (const FacadePoint& p : site.points) {
    if (p.plane != 1) continue;
    const auto c = static_cast<std::size_t>(std::clamp<double>(p.u / site.step, 0, static_cast<double>(columns) - 1));
    if (p.v < low[c].v) low[c] = {p.u, p.v};
    if (p.v > high[c].v) high[c] = {p.u, p.v};
  }
  OutlineRing ring;
  for (const Place2& p : low)
    if (std::isfinite(p.v)) ring.push_back(p);
  for (std::size_t c = columns; c-- > 0;)
    if (std::isfinite(high[c].v)) ring.push_back(high[c]);
  return ring;
}

// A wall of 6 m under a top, scanned from the street; its height is what is seen of it.
FacadeSite wall_under(const Height& top, const std::function<bool(Place2)>& hidden = {}, double step = 0.003) {
  test::ScannedWall wall;
  wall.height = 6;
  wall.wall({});
  FacadeSite site = test::scan_wall(wall, {1, 1.2, 8}, step);
  std::erase_if(site.points, [&](const FacadePoint& p) { return p.v > top(p.u) || (hidden && hidden({p.u, p.v})); });
  site.height = 0;
  for (const FacadePoint& p : site.points) site.height = std::max<double>(site.height, p.v);
  site.rings = {ring_of(site)};
  return site;
}

WallOutline outline_of(const FacadeSite& site) {
  const RaySamples samples(site);
  return wall_outline(samples);
}

TEST(WallOutline, RectanglesStayAsTheyAre) {
  for (const FacadeSite& site : {wall_under([](double) { return 4.0; }), FacadeSite{}}) {
    const WallOutline outline = outline_of(site);
    EXPECT_TRUE(outline.edges.empty());
    ASSERT_EQ(outline.ring.size(), 4u);
    EXPECT_EQ(outline.ring[2].u, site.width);
    EXPECT_EQ(outline.ring[2].v, site.height);
  }
}

// Every corner of a gable, and every place of its slopes within what the edge says.
TEST(WallOutline, GablesWithinTheirErrors) {
  const WallOutline outline = outline_of(wall_under(gable_top));
  const std::vector<Place2> truth{{0, 0}, {6, 0}, {6, 3}, {3, 4.8}, {0, 3}};
  ASSERT_EQ(outline.ring.size(), 5u);
  ASSERT_EQ(outline.edges.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(outline.ring[i].u, truth[i].u, 0.03) << i;
    EXPECT_NEAR(outline.ring[i].v, truth[i].v, 0.03) << i;
    EXPECT_EQ(outline.edges[i].status, DrawnStatus::seen);
  }
  for (const std::size_t i : {2u, 3u}) {
    const Place2 &a = outline.ring[i], &b = outline.ring[i + 1];
    EXPECT_GT(outline.edges[i].error_m, 0);
    EXPECT_LT(outline.edges[i].error_m, 0.03);
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      const double u = a.u + share * (b.u - a.u), v = a.v + share * (b.v - a.v);
      EXPECT_LT(std::abs(v - gable_top(u)) / std::sqrt(1 + 0.36), outline.edges[i].error_m) << i << ' ' << share;
    }
  }
}

TEST(WallOutline, StepsAreUpright) {
  const WallOutline outline = outline_of(wall_under([](double u) { return u < 4 ? 5.0 : 3.5; }));
  ASSERT_EQ(outline.ring.size(), 6u);
  EXPECT_NEAR(outline.ring[2].v, 3.5, outline.edges[2].error_m);
  EXPECT_EQ(outline.ring[2].v, outline.ring[3].v);
  EXPECT_NEAR(outline.ring[3].u, 4, outline.edges[3].error_m);
  EXPECT_EQ(outline.ring[3].u, outline.ring[4].u);
  EXPECT_NEAR(outline.ring[4].v, 5, 0.03);
}

// A tree hides a stretch of the slope: the line goes on, and says that nobody saw it.
TEST(WallOutline, HiddenStretchesOfASlopeAreOccluded) {
  const WallOutline outline =
      outline_of(wall_under(gable_top, [](Place2 p) { return p.u > 1 && p.u < 1.6 && p.v > 2.5; }));
  double seen = 0, hidden = 0;
  for (std::size_t i = 0; i < outline.ring.size(); ++i) {
    const Place2 &a = outline.ring[i], &b = outline.ring[(i + 1) % outline.ring.size()];
    if (a.u == b.u || a.v == b.v || a.u > 3.1) continue;
    (outline.edges[i].status == DrawnStatus::seen ? seen : hidden) += a.u - b.u;
    EXPECT_LT(std::abs(a.v - gable_top(a.u)), 0.04);
  }
  EXPECT_NEAR(hidden, 0.6, 0.1);
  EXPECT_NEAR(seen, 2.4, 0.1);
}

// A slope ends high above the roof beside it: it does not go on to where the two would meet.
TEST(WallOutline, SlopesEndWhereTheyWereSeen) {
  const WallOutline outline = outline_of(wall_under([](double u) { return u < 4 ? 5 - 0.4 * u : 2.5; }));
  ASSERT_EQ(outline.ring.size(), 6u);
  const std::vector<Place2> truth{{0, 0}, {6, 0}, {6, 2.5}, {4, 2.5}, {4, 3.4}, {0, 5}};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(outline.ring[i].u, truth[i].u, 0.03) << i;
    EXPECT_NEAR(outline.ring[i].v, truth[i].v, 0.03) << i;
  }
}

// A gap between higher stretches is no step, and what stands before the wall hides it.
TEST(WallOutline, GapsAndObjectsBeforeTheWallAreNoSteps) {
  EXPECT_TRUE(outline_of(wall_under([](double u) { return u > 2 && u < 4 ? 3.5 : 5.0; })).edges.empty());
  FacadeSite site = wall_under([](double u) { return u < 4 ? 5.0 : 3.5; });
  for (float u = 4; u < 6; u += 0.02F)
    for (float v = 3.5F; v < 5; v += 0.02F) site.points.push_back({u, v, 0.6F, 7});
  EXPECT_TRUE(outline_of(site).edges.empty());
}

// The ring of a plane ends where points become too sparse for it. Where the wall is seen to go on, this is no edge.
TEST(WallOutline, TheWallGoesOnAboveWhereItsPlaneEnds) {
  FacadeSite site = wall_under([](double) { return 5.0; });
  for (Place2& p : site.rings[0])
    if (p.v > 1) p.v = std::min(p.v, 5 - 0.7 * std::max(0.0, p.u - 2));
  EXPECT_TRUE(outline_of(site).edges.empty());
}

// Between two edges of which something is known, the wall is no higher than the higher one, unless it is seen there.
TEST(WallOutline, AnUnknownStretchIsNoTower) {
  FacadeSite site = wall_under([](double u) { return u < 1.5 ? 5.0 : u < 3 || u > 4.5 ? 3.0 : 1.0; });
  const WallOutline outline = outline_of(site);
  for (const Place2& p : outline.ring)
    if (p.u > 1.6) {
      EXPECT_LT(p.v, 3.1) << p.u;
    }
}

}  // namespace
}  // namespace ilot
