// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/shutters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/products/facades/elements/facade_model.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

using test::ScannedWall;
using test::Sheet;

constexpr Vec3 kLeafEye{1.5, 1.4, 8};
constexpr double kLeafStep = 0.002, kLow = 1.5, kHigh = 3.2;
const Sheet kFirst{2, 0, 0.8, 1.9, kLow, kHigh}, kMiddle{2, 0, 2.6, 3.7, kLow, kHigh},
    kLast{2, 0, 4.4, 5.5, kLow, kHigh};

// A wall with windows that have bars before their panes, so that these are no even sheets.
ScannedWall barred(const std::vector<Sheet>& windows, double width = 6) {
  ScannedWall wall;
  wall.width = width;
  wall.wall(windows);
  for (const Sheet& h : windows)
    for (double u = h.low_a + 0.2; u < h.high_a; u += 0.3)
      wall.sheets.push_back({2, -0.21, u, u + 0.06, h.low_b, h.high_b, 0});
  return wall;
}

std::vector<FacadeElement> drawn(const ScannedWall& wall, const std::string& kind, std::uint32_t planes = 12) {
  FacadeSite site = test::scan_wall(wall, kLeafEye, kLeafStep);
  for (std::uint32_t plane = 2; plane < planes; ++plane) site.parallel.push_back({plane, 100});
  std::vector<FacadeElement> found;
  for (const FacadeElement& e : find_facade(site).facade.elements)
    if (e.kind == kind) found.push_back(e);
  return found;
}

// Corners of a rectangle in the axes of the wall are corners in the CRS: x, and z upwards.
void expect_box(const FacadeElement& e, double u0, double u1, double v0, double v1, double within) {
  EXPECT_NEAR(e.ring[0].x, u0, within);
  EXPECT_NEAR(e.ring[1].x, u1, within);
  EXPECT_NEAR(e.ring[0].z, v0, within);
  EXPECT_NEAR(e.ring[2].z, v1, within);
}

TEST(Shutters, ClosedLeavesBeforeTheWallAreAWindow) {
  ScannedWall wall = barred({kFirst, kLast});
  wall.block(2.6, 3.7, kLow, kHigh, 0.04, 2);
  const auto windows = drawn(wall, "window"), leaves = drawn(wall, "shutter");
  ASSERT_EQ(windows.size(), 3u);
  expect_box(windows[1], 2.6, 3.7, kLow, kHigh, 0.01);
  EXPECT_EQ(windows[1].depth_m, 0);
  for (const FacadeEdge& edge : windows[1].edges) EXPECT_GE(edge.error_m, 0.01);  // the jamb itself is not seen
  ASSERT_EQ(leaves.size(), 1u);
  expect_box(leaves[0], 2.6, 3.7, kLow, kHigh, 0.01);
  EXPECT_NEAR(leaves[0].depth_m, 0.04, 0.003);
  EXPECT_EQ(leaves[0].reason, "closed");
  EXPECT_TRUE(drawn(wall, "bulge").empty());
}

TEST(Shutters, OpenLeavesAreThoseOfTheirWindow) {
  ScannedWall wall = barred({kMiddle});
  wall.block(2.04, 2.59, kLow + 0.01, kHigh, 0.05, 2);
  wall.block(3.71, 4.26, kLow + 0.01, kHigh, 0.05, 3);
  const auto windows = drawn(wall, "window"), leaves = drawn(wall, "shutter");
  ASSERT_EQ(windows.size(), 1u);
  expect_box(windows[0], 2.6, 3.7, kLow, kHigh, 0.03);
  ASSERT_EQ(leaves.size(), 2u);
  expect_box(leaves[0], 2.04, 2.59, kLow + 0.01, kHigh, 0.02);
  expect_box(leaves[1], 3.71, 4.26, kLow + 0.01, kHigh, 0.02);
  for (const FacadeElement& leaf : leaves) EXPECT_EQ(leaf.reason, "open");
  EXPECT_TRUE(drawn(wall, "bulge").empty());
}

// Moves the ends of the rays that meet an upright leaf, from its hinge to its tip in u and w, onto it.
void add_leaf(FacadeSite& site, Place2 hinge, Place2 tip, std::uint32_t plane) {
  const Place2 way{tip.u - hinge.u, tip.v - hinge.v};
  for (FacadePoint& p : site.points) {
    const double du = p.u - kLeafEye.x, dw = p.w - kLeafEye.z, across = du * way.v - dw * way.u;
    if (across == 0) continue;
    const double from_u = hinge.u - kLeafEye.x, from_w = hinge.v - kLeafEye.z;
    const double t = (from_u * way.v - from_w * way.u) / across, s = (from_u * dw - from_w * du) / across;
    const double v = kLeafEye.y + t * (p.v - kLeafEye.y);
    if (t <= 0 || t >= 1 || s < 0 || s > 1 || v < kLow || v > kHigh) continue;
    p = {static_cast<float>(kLeafEye.x + t * du), static_cast<float>(v), static_cast<float>(kLeafEye.z + t * dw),
         plane};
  }
}

TEST(Shutters, HalfOpenLeavesShowWhereTheirWindowEnds) {
  FacadeSite site = test::scan_wall(barred({kMiddle}), kLeafEye, kLeafStep);
  const double along = 0.55 * std::cos(1.0), out = 0.55 * std::sin(1.0);
  add_leaf(site, {2.6, 0.03}, {2.6 + along, 0.03 + out}, 20);
  add_leaf(site, {3.7, 0.03}, {3.7 - along, 0.03 + out}, 21);
  std::vector<FacadeElement> windows, leaves;
  for (const FacadeElement& e : find_facade(site).facade.elements) {
    if (e.kind == "window") windows.push_back(e);
    if (e.kind == "shutter") leaves.push_back(e);
  }
  ASSERT_EQ(windows.size(), 1u);
  expect_box(windows[0], 2.6, 3.7, kLow, kHigh, 0.04);
  for (const FacadeEdge& edge : windows[0].edges) EXPECT_LT(edge.error_m, 0.1);
  ASSERT_EQ(leaves.size(), 2u);
  for (const FacadeElement& leaf : leaves) {
    EXPECT_EQ(leaf.reason, "half open");
    EXPECT_NEAR(leaf.width_m, along, 0.03);
    EXPECT_NEAR(leaf.depth_m, 0.03 + out, 0.03);
  }
}

TEST(Shutters, LeavesAndBlindsWithinTheReveal) {
  ScannedWall wall = barred({kFirst, kMiddle, kLast, {2, 0, 6.2, 7.3, kLow, kHigh}}, 8);
  wall.sheets.push_back({2, -0.05, 2.6, 3.7, kLow, kHigh, 0});  // closed leaves
  wall.sheets.push_back({2, -0.1, 4.4, 5.5, 2.5, kHigh, 0});    // a blind, half down
  EXPECT_EQ(drawn(wall, "window").size(), 4u);
  const auto leaves = drawn(wall, "shutter");
  ASSERT_EQ(leaves.size(), 2u) << (leaves.empty() ? "none" : leaves[0].reason);
  expect_box(leaves[0], 2.6, 3.7, kLow, kHigh, 0.02);
  EXPECT_NEAR(leaves[0].depth_m, -0.05, 0.005);
  EXPECT_EQ(leaves[0].reason, "closed");
  expect_box(leaves[1], 4.4, 5.5, 2.5, kHigh, 0.1);
  EXPECT_NEAR(leaves[1].depth_m, -0.1, 0.005);
  EXPECT_EQ(leaves[1].reason, "blind");
}

TEST(Shutters, EvenPanesAtOneDepthAreNoLeaves) {
  ScannedWall wall;
  wall.wall({kFirst, kMiddle, kLast});
  EXPECT_EQ(drawn(wall, "window").size(), 3u);
  EXPECT_TRUE(drawn(wall, "shutter").empty());
}

TEST(Shutters, WhatElseLiesOnAWallIsNone) {
  struct Other {
    const char* what;
    std::vector<Sheet> plates;
  };
  const std::vector<Other> others{
      {"pilasters", {{2, 0, 2.1, 2.5, 0, 4}, {2, 0, 3.8, 4.2, 0, 4}}},
      {"panels below windows", {{2, 0, 0.8, 1.9, 0.6, 1.3}, {2, 0, 2.6, 3.7, 0.6, 1.3}, {2, 0, 4.4, 5.5, 0.6, 1.3}}},
      {"a sign over three windows", {{2, 0, 0.8, 5.5, 3.4, 3.8}}},
      {"a board between two windows, of another height", {{2, 0, 2, 2.5, 1.5, 2.1}}},
      {"quoins",
       {{2, 0, 0, 0.5, 0.4, 0.8}, {2, 0, 0, 0.5, 1.3, 1.7}, {2, 0, 0, 0.5, 2.2, 2.6}, {2, 0, 0, 0.5, 3.1, 3.5}}},
      {"two pilasters on one backing",
       {{2, 0.02, 1.95, 2.55, 0, 4}, {2, 0, 1.97, 2.2, 0, 4}, {2, 0, 2.32, 2.55, 0, 4}}},
      {"panels on one board",
       {{2, 0.02, 0.6, 5.7, 0.4, 1.3},
        {2, 0, 0.8, 1.9, 0.5, 1.2},
        {2, 0, 2.14, 3.24, 0.5, 1.2},
        {2, 0, 3.48, 4.58, 0.5, 1.2}}},
      {"a downpipe", {{2, 0, 2.2, 2.31, 0, 4}}}};
  for (const Other& other : others) {
    ScannedWall wall = barred({kFirst, kMiddle, kLast});
    std::uint32_t plane = 2;
    for (const Sheet& p : other.plates)
      wall.block(p.low_a, p.high_a, p.low_b, p.high_b, p.at > 0 ? p.at : 0.04, plane++);
    EXPECT_EQ(drawn(wall, "window").size(), 3u) << other.what;
    EXPECT_TRUE(drawn(wall, "shutter").empty()) << other.what;
  }
}

TEST(Shutters, OnePlateWithoutAnythingAlikeIsNoWindow) {
  ScannedWall wall;
  wall.wall({});
  wall.block(2.6, 3.7, kLow, kHigh, 0.04, 2);
  EXPECT_TRUE(drawn(wall, "window").empty());
  EXPECT_TRUE(drawn(wall, "shutter").empty());
  EXPECT_EQ(drawn(wall, "bulge").size(), 1u);
}

FlatPlate plate_at(double u0, double u1, double v0, double v1, bool left, bool right) {
  FlatPlate plate;
  plate.shape.side(Side::left).at = u0, plate.shape.side(Side::right).at = u1;
  plate.shape.side(Side::bottom).at = v0, plate.shape.side(Side::top).at = v1;
  plate.shape.depth = 0.04;
  for (const Side s : kSides) plate.wall[static_cast<std::size_t>(s)] = 1;
  plate.wall[static_cast<std::size_t>(Side::left)] = left;
  plate.wall[static_cast<std::size_t>(Side::right)] = right;
  return plate;
}

// The window between two open leaves gave no echo; the closed leaves beside it are as it.
TEST(Shutters, ClosedLeavesLikeAWindowBetweenOpenOnes) {
  const std::vector<FlatPlate> plates{plate_at(0.5, 0.9, 1, 2.5, true, false), plate_at(1.7, 2.1, 1, 2.5, false, true),
                                      plate_at(3, 3.8, 1, 2.5, true, true)};
  std::vector<FoundRectangle> openings;
  const std::vector<ShutterLeaf> leaves = find_shutters({plates, {}}, 0.04, 0.05, openings);
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_NEAR(openings[0].box().u0, 0.9, 1e-9);
  EXPECT_NEAR(openings[1].box().u0, 3, 1e-9);
  ASSERT_EQ(leaves.size(), 3u);
  EXPECT_EQ(leaves[0].state, LeafState::open);
  EXPECT_EQ(leaves[1].state, LeafState::open);
  EXPECT_EQ(leaves[2].state, LeafState::closed);
}

// The wall between two plates, or other leaves of which too little is seen for a plate, is no window between open
// leaves.
TEST(Shutters, WhatStopsRaysIsNoWindowBetweenOpenLeaves) {
  const std::vector<FlatPlate> plates{plate_at(0.5, 0.9, 1, 2.5, true, false), plate_at(1.7, 2.1, 1, 2.5, false, true)};
  for (const WallCells::What what : {WallCells::kUnknown, WallCells::kThrough, WallCells::kSolid, WallCells::kRelief}) {
    ReliefCells relief;
    relief.cells.cell = 0.1, relief.cells.columns = 30, relief.cells.rows = 30;
    relief.cells.what.assign(900, what);
    relief.out.assign(900, 0);
    std::vector<FoundRectangle> openings;
    const bool stands = what == WallCells::kRelief;
    EXPECT_EQ(find_shutters({plates, relief}, 0.04, 0.05, openings).size(), stands ? 0u : 2u);
    EXPECT_EQ(openings.size(), stands ? 0u : 1u);
  }
}

// A sign as high as half of them, and one three times as wide.
TEST(Shutters, SignsBesideAWindowBetweenOpenLeavesAreNone) {
  for (const Box2& sign : {Box2{3, 3.8, 1.7, 2.5}, Box2{3, 5.5, 1, 2.5}}) {
    const std::vector<FlatPlate> plates{plate_at(0.5, 0.9, 1, 2.5, true, false),
                                        plate_at(1.7, 2.1, 1, 2.5, false, true),
                                        plate_at(sign.u0, sign.u1, sign.v0, sign.v1, true, true)};
    std::vector<FoundRectangle> openings;
    EXPECT_EQ(find_shutters({plates, {}}, 0.04, 0.05, openings).size(), 2u);
    EXPECT_EQ(openings.size(), 1u);
  }
}

TEST(Shutters, AFrontWithAllLeavesClosed) {
  ScannedWall wall;
  wall.wall({});
  std::uint32_t plane = 2;
  for (const Sheet& h : {kFirst, kMiddle, kLast}) wall.block(h.low_a, h.high_a, h.low_b, h.high_b, 0.04, plane++);
  EXPECT_EQ(drawn(wall, "window").size(), 3u);
  EXPECT_EQ(drawn(wall, "shutter").size(), 3u);
}

}  // namespace
}  // namespace ilot
