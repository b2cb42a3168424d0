// SPDX-License-Identifier: Apache-2.0
// The street side of walls that are seen by real rays from one station.
#include "engine/products/facades/walls/street_side.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace ilot {
namespace {

constexpr double kWallWidth = 10, kWallHeight = 7, kPane = -0.2;

bool in_window(double u, double v) {
  const double across = std::fmod(u, 2.5), up = std::fmod(v, 3.0);
  return across > 0.8 && across < 1.9 && up > 1.0 && up < 2.4;
}

// What a scanner at the place sees of a wall with windows, with panes behind it, or before it when `mirrored`.
struct SeenWall {
  FacadeSite site;
  std::vector<FacadePoint> points;

  explicit SeenWall(Vec3 eye, double mirror = 1) {
    site.width = kWallWidth, site.height = kWallHeight;
    site.step = 0.04;
    site.wall = {1};
    for (double u = 0.02; u < kWallWidth; u += 0.04)
      for (double v = 0.02; v < kWallHeight; v += 0.04) {
        if (!in_window(u, v)) {
          points.push_back({static_cast<float>(u), static_cast<float>(v), 0, 1});
          continue;
        }
        const double along = (eye.z - kPane) / eye.z;
        add(eye.x + along * (u - eye.x), eye.y + along * (v - eye.y), mirror * kPane);
      }
  }
  void add(double u, double v, double w) {
    points.push_back({static_cast<float>(u), static_cast<float>(v), static_cast<float>(w), 0});
  }
  SideEvidence evidence() const {
    return side_evidence(sample_wall(site, [&](const TakeFacadePoints& take) { take(points, {}); }));
  }
};

TEST(StreetSide, PanesLieBehindTheWall) {
  for (const Vec3 eye : {Vec3{5, 1.7, 10}, Vec3{0, 1.7, 6}, Vec3{12, 1.7, 6}}) {
    const SideEvidence e = SeenWall(eye).evidence();
    EXPECT_LT(e.blocked[0], 0.02);
    EXPECT_EQ(e.blocked[1], 0);  // nothing lies before the wall
    EXPECT_EQ(e.ground, (std::array<double, 2>{0, 0}));
    EXPECT_GT(street_log_odds(e), 1.1);  // all that is not wall lies behind it
  }
}

// Reliefs on the wall cannot have been seen through it.
TEST(StreetSide, WhatStandsBeforeTheWallIsBlockedFromBehind) {
  SeenWall seen({5, 1.7, 10});
  for (double u = 0; u < kWallWidth; u += 0.1)
    for (double v = 2.6; v < 2.9; v += 0.1) seen.add(u, v, 0.25);
  const SideEvidence e = seen.evidence();
  EXPECT_GT(e.blocked[1], 0.4);
  EXPECT_GT(street_log_odds(e), 1.1);
}

TEST(StreetSide, GroundLiesBeforeAndRoofsRiseBehind) {
  SeenWall ground({5, 1.7, 10});
  for (double u = 0; u < kWallWidth; u += 0.1)
    for (double w = 0.05; w < 1.2; w += 0.1) ground.add(u, -0.05 + 0.02 * u, w);
  EXPECT_GT(ground.evidence().ground[0], 0.9);
  EXPECT_EQ(ground.evidence().ground[1], 0);
  EXPECT_GT(street_log_odds(ground.evidence()), 3);

  SeenWall roof({5, 1.7, 10});
  for (double u = 0; u < kWallWidth; u += 0.1)
    for (double w = 0; w < 3.5; w += 0.1) roof.add(u, kWallHeight + 0.1 + w, -w);
  EXPECT_GT(roof.evidence().beyond[0], 0.9);
  EXPECT_EQ(roof.evidence().beyond[1], 0);
  EXPECT_GT(street_log_odds(roof.evidence()), 2);
}

// A pane that reaches down to the foot of the wall is no ground behind it.
TEST(StreetSide, ShopWindowsAreNoGround) {
  SeenWall seen({5, 1.7, 10});
  for (double u = 0; u < kWallWidth; u += 0.05)
    for (double v = 0; v < 2; v += 0.05) seen.add(u, v, -0.3);
  EXPECT_EQ(seen.evidence().ground, (std::array<double, 2>{0, 0}));
}

// The same scene seen in a mirror says the opposite, to the last digit.
TEST(StreetSide, TheMirroredWallGivesTheOppositeOdds) {
  SeenWall seen({3, 1.7, 8}), mirrored({3, 1.7, 8}, -1);
  for (double u = 0; u < kWallWidth; u += 0.13) {
    seen.add(u, 0.1, 0.62), mirrored.add(u, 0.1, -0.62);
    seen.add(u, 0.1, 0.82), mirrored.add(u, 0.1, -0.82);
  }
  EXPECT_GT(street_log_odds(seen.evidence()), 0);
  EXPECT_DOUBLE_EQ(street_log_odds(seen.evidence()), -street_log_odds(mirrored.evidence()));
}

// The sample depends on the places of points only.
TEST(StreetSide, TheOrderOfPointsDoesNotMatter) {
  SeenWall seen({3, 1.7, 8});
  for (double u = 0; u < kWallWidth; u += 0.01)
    for (double w = 0.05; w < 2; w += 0.02) seen.add(u, 0.1 * std::sin(9 * u), w);
  const SideEvidence before = seen.evidence();
  std::reverse(seen.points.begin(), seen.points.end());
  EXPECT_EQ(before.blocked, seen.evidence().blocked);
  EXPECT_EQ(before.ground, seen.evidence().ground);
}

}  // namespace
}  // namespace ilot
