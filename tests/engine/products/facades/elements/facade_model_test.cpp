// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/facade_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "engine/deliverables/tables/facade_json.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

using test::ScannedWall;
using test::Sheet;

constexpr Vec3 kModelEye{-2, 1.2, 7};
const std::vector<Sheet> kWindows{{2, 0, 0.8, 1.9, 1.5, 3.2}, {2, 0, 2.6, 3.7, 1.5, 3.2}, {2, 0, 4.4, 5.5, 1.5, 3.2}};

ScannedWall windows_with_sills() {
  ScannedWall wall;
  wall.wall(kWindows);
  std::uint32_t plane = 2;
  for (const Sheet& h : kWindows) wall.block(h.low_a - 0.07, h.high_a + 0.07, 1.38, 1.5, 0.09, plane++);
  return wall;
}

FacadeSite scanned(const ScannedWall& wall, double step = 0.0025) {
  FacadeSite site = test::scan_wall(wall, kModelEye, step);
  for (std::uint32_t plane = 2; plane < 5; ++plane) site.parallel.push_back({plane, 100});
  return site;
}

std::vector<FacadeElement> of_kind(const Facade& facade, const std::string& kind) {
  std::vector<FacadeElement> found;
  for (const FacadeElement& e : facade.elements)
    if (e.kind == kind) found.push_back(e);
  return found;
}

double left(const FacadeElement& e) {
  return e.ring[0].x;
}
double right(const FacadeElement& e) {
  return e.ring[1].x;
}
double bottom(const FacadeElement& e) {
  return e.ring[0].z;
}
double top(const FacadeElement& e) {
  return e.ring[2].z;
}

// A window between two places along the wall, with the sill and the head of the others.
FoundRectangle rectangle(double u0, double u1) {
  FoundRectangle r;
  r.side(Side::left).at = u0, r.side(Side::right).at = u1, r.side(Side::bottom).at = 1.5, r.side(Side::top).at = 3.2;
  for (LocatedEdge& e : r.sides) e.error = 0.2, e.inner = e.at;
  return r;
}

// A strip above a window, whose lower end is hidden and comes from the size of the others, then covers the window
// itself.
TEST(FacadeModel, AnOpeningWithinAnotherIsTheSame) {
  const FacadeSite site = scanned(windows_with_sills());
  SparseFindings sparse;
  sparse.openings = {rectangle(7, 8.1), rectangle(7, 8.1)};
  LocatedEdge &bottom = sparse.openings[1].side(Side::bottom), &top = sparse.openings[1].side(Side::top);
  top.at = top.inner = 3.6;
  bottom.at = bottom.inner = 3.25, bottom.status = DrawnStatus::occluded, bottom.error = 3;
  sparse.box = {0, 9, 0, site.height};
  sparse.step = 0.3;
  EXPECT_EQ(of_kind(find_facade(RaySamples(site), {}, nullptr, sparse).facade, "window").size(), 4u);
  sparse.openings[1].side(Side::left).at = 8.2, sparse.openings[1].side(Side::right).at = 9.3;  // beside it
  EXPECT_EQ(of_kind(find_facade(RaySamples(site), {}, nullptr, sparse).facade, "window").size(), 5u);
}

// A strip of a window is seen below something that hides the wall up to the eaves.
TEST(FacadeModel, AStripOfAnOpeningIsAPossibleOne) {
  const FacadeSite site = scanned(windows_with_sills());
  SparseFindings sparse;
  sparse.openings = {rectangle(7, 8.1)};
  LocatedEdge& top = sparse.openings[0].side(Side::top);
  top.at = top.inner = 1.8, top.status = DrawnStatus::occluded, top.error = 3, top.beyond = 1.2;
  sparse.box = {0, 9, 0, site.height};
  sparse.step = 0.3;
  const Facade facade = find_facade(RaySamples(site), {}, nullptr, sparse).facade;
  EXPECT_EQ(of_kind(facade, "window").size(), 3u);
  const auto possible = of_kind(facade, "possible opening");
  ASSERT_EQ(possible.size(), 1u);
  EXPECT_EQ(possible[0].reason, "too little of this opening was seen");
  EXPECT_NEAR(possible[0].height_m, 0.3, 1e-9);
}

// Beyond the end of the wall, where its points are sparse, a window was found, and one of the wall once more.
TEST(FacadeModel, SparsePartsBelongToTheFacade) {
  const FacadeSite site = scanned(windows_with_sills());
  SparseFindings sparse;
  sparse.openings = {rectangle(7, 8.1), rectangle(4.5, 5.6)};
  sparse.box = {0, 9, 0, site.height};
  sparse.step = 0.3;
  const Facade facade = find_facade(RaySamples(site), {}, nullptr, sparse).facade;
  ASSERT_EQ(of_kind(facade, "window").size(), 4u);
  EXPECT_NEAR(right(of_kind(facade, "window")[3]), 8.1, 0.2);
  EXPECT_NEAR(facade.width_m, 9, 1e-9);
  for (const FacadeEdge& edge : facade.elements[0].edges) EXPECT_EQ(edge.error_m, 0.3);
}

TEST(FacadeModel, EveryWindowToTheMillimetre) {
  const FoundFacade found = find_facade(scanned(windows_with_sills()));
  const auto windows = of_kind(found.facade, "window");
  ASSERT_EQ(windows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(windows[i].opening);
    EXPECT_NEAR(left(windows[i]), kWindows[i].low_a, windows[i].edges[3].error_m);  // hidden, known to a step
    EXPECT_LT(windows[i].edges[3].error_m, 0.02);
    EXPECT_NEAR(right(windows[i]), kWindows[i].high_a, 0.003);
    EXPECT_NEAR(top(windows[i]), kWindows[i].high_b, 0.003);
    EXPECT_NEAR(bottom(windows[i]), kWindows[i].low_b, 0.006);
    EXPECT_NEAR(windows[i].depth_m, -0.25, 0.003);
    EXPECT_EQ(windows[i].column, i + 1);
    EXPECT_EQ(windows[i].family, windows[0].family);
    EXPECT_NE(windows[i].family, 0u);
  }
  const auto sills = of_kind(found.facade, "sill");
  ASSERT_EQ(sills.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(left(sills[i]), kWindows[i].low_a - 0.07, sills[i].edges[3].error_m + 0.003);
    EXPECT_NEAR(right(sills[i]), kWindows[i].high_a + 0.07, sills[i].edges[1].error_m + 0.003);
    EXPECT_NEAR(top(sills[i]), 1.5, 0.005);
    EXPECT_NEAR(bottom(sills[i]), 1.38, 0.005);
    EXPECT_NEAR(sills[i].depth_m, 0.09, 0.002);
  }
}

// A bottom behind a sill that is seen from below is the sill's top, and says so.
TEST(FacadeModel, HiddenBottomsAreCompleted) {
  ScannedWall wall = windows_with_sills();
  FacadeSite site = test::scan_wall(wall, {-2, 0, 7}, 0.0025);
  for (std::uint32_t plane = 2; plane < 5; ++plane) site.parallel.push_back({plane, 100});
  const auto windows = of_kind(find_facade(site).facade, "window");
  ASSERT_EQ(windows.size(), 3u);
  for (const FacadeElement& w : windows) {
    EXPECT_EQ(w.edges[0].status, DrawnStatus::completed);
    EXPECT_NEAR(bottom(w), 1.5, 0.006);
    EXPECT_FALSE(w.reason.empty());
  }
}

// What stood in the street is gone, its shadow is a hole in the wall's points: no window.
TEST(FacadeModel, ShadowsAreNoOpenings) {
  ScannedWall wall;
  wall.wall({kWindows[0]});
  wall.block(2.3, 2.9, 0.5, 2.5, 3.0, 7);
  for (Sheet& s : wall.sheets)
    if (s.plane == 0 && s.axis != 2 && s.high_b > 2.9) s.plane = 7;
  const FacadeSite site = test::scan_wall(wall, kModelEye, 0.004, 7);
  // The shadow is there and larger than a window.
  std::size_t in_shadow = 0;
  for (const FacadePoint& p : site.points) in_shadow += p.u > 5.3 && p.u < 5.7 && p.v > 1 && p.v < 2.4;
  EXPECT_EQ(in_shadow, 0u);
  const FoundFacade found = find_facade(site);
  const auto windows = of_kind(found.facade, "window");
  ASSERT_EQ(windows.size(), 1u);
  EXPECT_NEAR(left(windows[0]), 0.8, 0.02);
  EXPECT_TRUE(of_kind(found.facade, "door").empty());
}

// Joints of banded stone run from one opening to the next: the back of a joint was seen, so nothing is open there.
TEST(FacadeModel, JointsJoinNoOpenings) {
  for (const double pier : {0.4, 0.7}) {
    const double u = 2.6 - pier / 2;
    ScannedWall wall;
    const std::vector<Sheet> doors{{2, -0.45, u - 1.2, u, 0, 3.2}, {2, -0.45, u + pier, u + pier + 1.2, 0, 3.2}};
    std::vector<Sheet> holes = doors;
    for (const double v : {0.9, 1.7, 2.5}) holes.push_back({2, -0.02, u, u + pier, v, v + 0.07});
    wall.wall(holes);
    const FacadeSite left_scan = test::scan_wall(wall, {-1, 1.6, 7}, 0.0025);
    const FacadeSite both = test::joined(left_scan, test::scan_wall(wall, {8, 1.6, 7}, 0.0025));
    for (const FacadeSite& site : {left_scan, both}) {
      const auto found = of_kind(find_facade(site).facade, "door");
      ASSERT_EQ(found.size(), 2u) << pier << " " << site.stations.size();
      for (std::size_t i = 0; i < 2; ++i) {
        // Beside a jamb a ray may be taken for one of the other station.
        EXPECT_NEAR(left(found[i]), doors[i].low_a, site.stations.size() == 1 ? 0.01 : 0.03);
        EXPECT_NEAR(right(found[i]), doors[i].high_a, 0.01);
      }
    }
  }
}

// A long low thing that one can stand on is a balcony, a high one a part of the house.
// Moved by a part of a cell at a time: how the cells of the depth image fall must not matter.
TEST(FacadeModel, BalconiesAndBays) {
  for (int i = 0; i < 12; ++i) {
    const double by = 0.005 * i;
    ScannedWall wall;
    wall.wall({});
    wall.block(0.5 + by, 3.9 + by, 2.2 + by, 3.3 + by, 0.8, 9);  // on no segment that lies along the wall
    wall.block(4.6 + by, 5.6 + by, 0.6 + by, 3.4 + by, 0.5, 10);
    wall.block(0.6, 3.6, 0.8, 0.84, 0.07, 2);
    FacadeSite site = test::scan_wall(wall, {2.6, 1.6, 7}, 0.0025);
    site.parallel.push_back({2, 100});
    const Facade facade = find_facade(site).facade;
    const auto balconies = of_kind(facade, "balcony"), bays = of_kind(facade, "protrusion");
    ASSERT_EQ(balconies.size(), 1u) << by;
    EXPECT_NEAR(left(balconies[0]), 0.5 + by, 0.03) << by;
    EXPECT_NEAR(right(balconies[0]), 3.9 + by, 0.03) << by;
    EXPECT_NEAR(bottom(balconies[0]), 2.2 + by, 0.005) << by << ": its soffit was seen";
    EXPECT_NEAR(balconies[0].depth_m, 0.8, 0.003) << by;
    ASSERT_EQ(bays.size(), 1u) << by;
    EXPECT_NEAR(left(bays[0]), 4.6 + by, 0.005) << by << ": that side was seen";
    EXPECT_NEAR(bays[0].width_m, 1, 0.03) << by;
    EXPECT_NEAR(bays[0].height_m, 2.8, 0.03) << by;
    EXPECT_NEAR(bays[0].depth_m, 0.5, 0.003) << by;
  }
}

// A rail before the wall is not drawn, a bulge as long is.
TEST(FacadeModel, RailsAreNotDrawn) {
  for (const double height : {0.04, 0.3}) {
    ScannedWall wall;
    wall.wall({});
    wall.block(0.6, 1.8, 0.8, 0.8 + height, 0.07, 2);
    FacadeSite site = test::scan_wall(wall, {2.6, 1.6, 7}, 0.0025);
    site.parallel.push_back({2, 100});
    EXPECT_EQ(of_kind(find_facade(site).facade, "bulge").size(), height > 0.1 ? 1u : 0u);
  }
}

// Half as many rays: what is drawn stays within what it says of itself.
// Four stones and their joint, seen from the right, a wall standing out of them at the left.
FacadeSite four_stones(bool in_one_segment) {
  ScannedWall wall;
  wall.width = 1.235, wall.height = 0.835;
  std::uint32_t plane = 1;
  for (const double v : {0.0, 0.435})
    for (const double u : {0.0, 0.635})
      wall.sheets.push_back({2, 0, u, u + 0.6, v, v + 0.4, in_one_segment ? 1 : plane++});
  wall.sheets.push_back({2, -0.02, 0, 1.235, 0, 0.835, 9});  // the back of the joint
  for (const double u : {0.6, 0.635}) wall.sheets.push_back({0, u, 0, 0.835, -0.02, 0, 0});
  for (const double v : {0.4, 0.435}) wall.sheets.push_back({1, v, 0, 1.235, -0.02, 0, 0});
  wall.sheets.push_back({0, 0, 0, 0.835, 0, 0.9, 10});
  FacadeSite site = test::scan_wall(wall, {5.7, 0.4, 6.1}, 0.0007, 999, 0.001);
  site.wall = in_one_segment ? std::vector<std::uint32_t>{1} : std::vector<std::uint32_t>{1, 2, 3, 4};
  site.parallel = {{9, 2000}};
  return site;
}

// Though the joint's flank on the left of each right stone cannot be seen, and whatever the segments.
TEST(FacadeModel, StonesAreRightToThreeMillimetres) {
  for (const bool in_one_segment : {false, true}) {
    const auto stones = of_kind(find_facade(four_stones(in_one_segment)).facade, "stone");
    ASSERT_EQ(stones.size(), 4u) << in_one_segment;
    for (const FacadeElement& s : stones) {
      const double u = left(s) > 0.3 ? 0.635 : 0, v = bottom(s) > 0.2 ? 0.435 : 0;
      EXPECT_NEAR(left(s), u, 0.003) << in_one_segment;
      EXPECT_NEAR(right(s), u + 0.6, 0.003) << in_one_segment;
      EXPECT_NEAR(bottom(s), v, 0.003) << in_one_segment;
      EXPECT_NEAR(top(s), v + 0.4, 0.003) << in_one_segment;
    }
  }
}

TEST(FacadeModel, EdgesLieWithinTheirErrors) {
  for (const double step : {0.002, 0.004, 0.0055}) {
    const auto windows = of_kind(find_facade(scanned(windows_with_sills(), step)).facade, "window");
    ASSERT_EQ(windows.size(), 3u) << step;
    for (std::size_t i = 0; i < 3; ++i) {
      const double truth[4] = {kWindows[i].low_b, kWindows[i].high_a, kWindows[i].high_b, kWindows[i].low_a};
      const double got[4] = {bottom(windows[i]), right(windows[i]), top(windows[i]), left(windows[i])};
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_LE(std::abs(got[k] - truth[k]), windows[i].edges[k].error_m + 0.003) << step << " " << i << " " << k;
    }
  }
}

TEST(FacadeModel, OrderOfPointsDoesNotMatter) {
  FacadeSite site = scanned(windows_with_sills(), 0.004);
  const auto before = of_kind(find_facade(site).facade, "window");
  std::reverse(site.points.begin(), site.points.end());
  const auto after = of_kind(find_facade(site).facade, "window");
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(norm(before[i].ring[k] - after[i].ring[k]), 0, 1e-9);
}

TEST(FacadeModel, WithoutStationsToo) {
  FacadeSite site = scanned(windows_with_sills(), 0.0025);
  site.stations.clear();
  const auto windows = of_kind(find_facade(site).facade, "window");
  ASSERT_EQ(windows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(left(windows[i]), kWindows[i].low_a, 0.02);
    EXPECT_NEAR(right(windows[i]), kWindows[i].high_a, 0.01);
    EXPECT_NEAR(top(windows[i]), kWindows[i].high_b, 0.01);
  }
}

TEST(FacadeModel, ElementsAreNumberedAndReadBack) {
  const FoundFacade found = find_facade(scanned(windows_with_sills(), 0.004));
  for (std::size_t i = 0; i < found.facade.elements.size(); ++i) EXPECT_EQ(found.facade.elements[i].id, i + 1);
  EXPECT_EQ(found.facade.elements[0].kind, "outline");
  EXPECT_EQ(facade_json(parse_facade_json(facade_json(found.facade), "f")), facade_json(found.facade));
}

}  // namespace
}  // namespace ilot
