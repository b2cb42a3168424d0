// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/regularise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"
#include "kernels/outlines/simple_ring.h"

namespace ilot {
namespace {

using Ring = std::vector<Point2>;

struct Corner {
  double x, y;
};

// A ring that follows the corners every `step`, each vertex up to `noise` inside of the edge, as boundary points lie.
Ring scanned(const std::vector<Corner>& corners, double step, double noise, Rng& rng) {
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner a = corners[i], b = corners[(i + 1) % corners.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, l = std::sqrt(dx * dx + dy * dy);
    for (double t = step / 2; t < l; t += step) {
      const double in = noise * rng.uniform();
      ring.push_back({static_cast<std::int32_t>(std::lround(a.x + t / l * dx - in * dy / l)),
                      static_cast<std::int32_t>(std::lround(a.y + t / l * dy + in * dx / l))});
    }
  }
  return ring;
}

std::vector<Corner> turned(std::vector<Corner> corners, double degrees) {
  const double a = degrees * 3.14159265358979 / 180;
  for (Corner& p : corners)
    p = {p.x * std::cos(a) - p.y * std::sin(a) + 200000, p.x * std::sin(a) + p.y * std::cos(a) - 100000};
  return corners;
}

// Largest distance from a corner of the truth to the nearest vertex found.
double worst_corner(const Ring& ring, const std::vector<Corner>& corners) {
  double worst = 0;
  for (const Corner& c : corners) {
    double nearest = 1e300;
    for (const Point2 p : ring) nearest = std::min(nearest, std::hypot(p.x - c.x, p.y - c.y));
    worst = std::max(worst, nearest);
  }
  return worst;
}

// Greatest cosine between edges that follow each other, in magnitude: 0 when all corners are square.
double worst_angle(const Ring& ring) {
  double worst = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
    worst = std::max(worst, std::abs(ux * vx + uy * vy) / std::hypot(ux, uy) / std::hypot(vx, vy));
  }
  return worst;
}

constexpr double kStep = 316, kTolerance = 400;
const RegulariseParams kParams{kTolerance, kStep / 2};

TEST(Regularise, ARectangleWithNoiseIsARectangle) {
  for (const double degrees : {0.0, 17.0, 45.0, 83.0}) {
    Rng rng(5);
    const auto truth = turned({{0, 0}, {12000, 0}, {12000, 8000}, {0, 8000}}, degrees);
    const auto found = regularise(std::vector<Ring>{scanned(truth, kStep, kStep, rng)}, kParams);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].size(), 4u) << degrees;
    EXPECT_LT(worst_corner(found[0], truth), 150) << degrees;
    EXPECT_LT(worst_angle(found[0]), 1e-3) << "rounded to the grid, else square";
  }
}

TEST(Regularise, AnExactRectangleStaysExact) {
  Rng rng(1);
  const std::vector<Corner> truth{{0, 0}, {12000, 0}, {12000, 8000}, {0, 8000}};
  const auto found = regularise(std::vector<Ring>{scanned(truth, 250, 0, rng)}, {100, 0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 4u);
  EXPECT_LT(worst_corner(found[0], truth), 1e-9);
}

TEST(Regularise, AnLShapeKeepsItsSixCorners) {
  Rng rng(6);
  const auto truth = turned({{0, 0}, {15000, 0}, {15000, 6000}, {7000, 6000}, {7000, 12000}, {0, 12000}}, 31);
  const auto found = regularise(std::vector<Ring>{scanned(truth, kStep, kStep, rng)}, kParams);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 6u);
  EXPECT_LT(worst_corner(found[0], truth), 250);
  EXPECT_LT(worst_angle(found[0]), 2e-3);
}

TEST(Regularise, ACornerOfThirtyDegreesIsKept) {
  Rng rng(7);
  const std::vector<Corner> truth{{0, 0}, {17320, 0}, {17320, 10000}};
  const auto found = regularise(std::vector<Ring>{scanned(truth, kStep, kStep / 2, rng)}, {kTolerance, kStep / 4});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 3u);
  EXPECT_LT(worst_corner(found[0], truth), 600) << "a sharp corner runs away four times as far as its edges err";
}

TEST(Regularise, AnObliqueWallOfASquareHouseIsKept) {
  Rng rng(8);
  const std::vector<Corner> truth{{0, 0}, {12000, 0}, {12000, 5000}, {8000, 9000}, {0, 9000}};
  const auto found = regularise(std::vector<Ring>{scanned(truth, kStep, kStep, rng)}, kParams);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 5u);
  EXPECT_LT(worst_corner(found[0], truth), 250);
}

TEST(Regularise, AStepInAWallStaysAStep) {
  Rng rng(9);
  const std::vector<Corner> truth{{0, 0}, {6000, 0}, {6000, 1500}, {14000, 1500}, {14000, 9000}, {0, 9000}};
  const auto found = regularise(std::vector<Ring>{scanned(truth, kStep, kStep, rng)}, kParams);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 6u);
  EXPECT_LT(worst_corner(found[0], truth), 250);
}

TEST(Regularise, AnInnerCornerThatTheBoundaryCutsAcrossIsSquare) {
  const auto truth = turned({{0, 0}, {15000, 0}, {15000, 6000}, {7000, 6000}, {7000, 12000}, {0, 12000}}, 31);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    Ring ring = scanned(truth, kStep, kStep, rng);
    std::erase_if(ring, [&](Point2 p) { return std::hypot(p.x - truth[3].x, p.y - truth[3].y) < 900; });
    const auto found = regularise(std::vector<Ring>{ring}, kParams);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].size(), 6u) << seed;
    EXPECT_LT(worst_corner(found[0], truth), 250) << seed;
  }
}

TEST(Regularise, ACourtyardMovesIntoItself) {
  Rng rng(10);
  const std::vector<Corner> outer{{0, 0}, {30000, 0}, {30000, 24000}, {0, 24000}};
  const std::vector<Corner> yard{{9000, 8000}, {9000, 16000}, {21000, 16000}, {21000, 8000}};
  const auto found =
      regularise(std::vector<Ring>{scanned(outer, kStep, kStep, rng), scanned(yard, kStep, kStep, rng)}, kParams);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].size(), 4u);
  EXPECT_EQ(found[1].size(), 4u);
  EXPECT_LT(worst_corner(found[0], outer), 150);
  EXPECT_LT(worst_corner(found[1], yard), 150);
  EXPECT_TRUE(is_simple_polygon(found));
}

TEST(Regularise, MovesAlongWithItsRings) {
  Rng rng(12);
  const auto truth = turned({{0, 0}, {15000, 0}, {15000, 6000}, {7000, 6000}, {7000, 12000}, {0, 12000}}, 12);
  Ring ring = scanned(truth, kStep, kStep, rng);
  auto found = regularise(std::vector<Ring>{ring}, kParams);
  for (Point2& p : ring) p = {p.x + 1234567, p.y - 7654321};
  const auto moved = regularise(std::vector<Ring>{ring}, kParams);
  for (Point2& p : found[0]) p = {p.x + 1234567, p.y - 7654321};
  EXPECT_EQ(found, moved);
}

TEST(Regularise, WhateverComesInNeverCrossesItself) {
  Rng rng(13);
  for (int n = 0; n < 400; ++n) {
    // A star around its centre is simple, however ragged.
    Ring ring;
    const int corners = 3 + static_cast<int>(rng.below(60));
    for (int i = 0; i < corners; ++i) {
      const double a = 2 * 3.14159265358979 * i / corners, r = 300 + 9000 * rng.uniform();
      ring.push_back({static_cast<std::int32_t>(std::lround(r * std::cos(a))),
                      static_cast<std::int32_t>(std::lround(r * std::sin(a)))});
    }
    if (!is_simple_polygon(std::vector<Ring>{ring})) continue;
    const auto found = regularise(std::vector<Ring>{ring}, kParams);
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(is_simple_polygon(found)) << n;
  }
}

TEST(Regularise, DegenerateRingsGiveNothingOrThemselves) {
  EXPECT_TRUE(regularise({}, kParams).empty());
  EXPECT_TRUE(regularise(std::vector<Ring>{{{0, 0}, {5, 5}}}, kParams).empty());
  const auto sliver = regularise(std::vector<Ring>{{{0, 0}, {9000, 0}, {9000, 20}}}, kParams);
  ASSERT_EQ(sliver.size(), 1u);
  EXPECT_TRUE(is_simple_polygon(sliver));
}

}  // namespace
}  // namespace ilot
