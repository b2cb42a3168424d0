// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/arched_top.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr double kArchLeft = 2, kArchRight = 3.2, kFoot = 1, kMiddle = (kArchLeft + kArchRight) / 2;

// Between the jambs and below the circle.
FacadeSite with_arch(double centre_u, double centre_v, double radius) {
  return test::scan_wall_open_where([=](double u, double v) {
    const double x = u - centre_u, y = v - centre_v;
    return u > kArchLeft && u < kArchRight && v > kFoot && (v < centre_v || x * x + y * y < radius * radius);
  });
}

void expect_arc(double centre_v, double radius) {
  const FacadeSite site = with_arch(kMiddle, centre_v, radius);
  const auto openings = find_openings(RaySamples(site));
  ASSERT_EQ(openings.size(), 1u);
  ASSERT_TRUE(openings[0].arc);
  EXPECT_NEAR(openings[0].arc->radius, radius, 0.02 * radius) << "of flat arcs the radius is known less well";
  EXPECT_NEAR(openings[0].arc->centre.u, kMiddle, 0.005);
  EXPECT_NEAR(openings[0].arc->centre.v + openings[0].arc->radius, centre_v + radius, 0.005) << "the crown";
}

TEST(ArchedTop, HalfACircle) {
  expect_arc(2.2, 0.6);
}

TEST(ArchedTop, ASegment) {
  expect_arc(1.9, 0.9);
}

TEST(ArchedTop, StraightStaysStraight) {
  const FacadeSite site = test::scan_wall_open_where(
      [](double u, double v) { return u > kArchLeft && u < kArchRight && v > kFoot && v < 3; });
  const auto openings = find_openings(RaySamples(site));
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_FALSE(openings[0].arc);
}

TEST(ArchedTop, OneThatRisesFromOneJambAloneIsNone) {
  const FacadeSite site = with_arch(kArchRight - 0.2, 1.8, 1);
  const auto openings = find_openings(RaySamples(site));
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_FALSE(openings[0].arc);
}

// A segmental arch whose surround hides the wall above it, in a wall with a joint that touches the crown.
TEST(ArchedTop, AFlatArchBelowASurroundAndBesideAJoint) {
  FacadeSite site;
  site.width = 10, site.height = 5;
  site.stations = {{{1, 1.2, 8}, 0.002, 0.002}};
  site.step = 0.016;
  site.parallel = {{7, 1000}};
  const double radius = 1.2, rise = 0.18, springing = 2.9, centre = springing + rise - radius;
  const double half = std::sqrt(radius * radius - (radius - rise) * (radius - rise));
  Rng rng(4);
  for (double a = 2; a < 6; a += 0.008)
    for (double b = 0.5; b < 4.5; b += 0.008) {
      const double x = a + 0.002 * rng.uniform(), y = b + 0.002 * rng.uniform();  // where the ray crosses the wall
      const auto add = [&](double w, std::uint32_t plane) {
        const double t = (8 - w) / 8;
        site.points.push_back({static_cast<float>(1 + (x - 1) * t), static_cast<float>(1.2 + (y - 1.2) * t),
                               static_cast<float>(w), plane});
      };
      const auto hole = [&](double u, double v) {
        const double off = std::sqrt((u - 4) * (u - 4) + (v - centre) * (v - centre));
        return std::abs(u - 4) < half && v > 1 && (v < springing || off < radius);
      };
      const double front_u = 1 + (x - 1) * 7.94 / 8, front_v = 1.2 + (y - 1.2) * 7.94 / 8;
      const bool surround = std::abs(front_u - 4) < half + 0.1 && front_v > 2.5 && front_v < 3.3;
      if (surround && !hole(front_u, front_v))
        add(0.06, 0);
      else if (hole(x, y))
        add(-0.25, 0);
      else if (y > springing + rise - 0.02 && y < springing + rise + 0.015)
        add(-0.02, 7);
      else
        add(0, 1);
    }
  const auto openings = find_openings(RaySamples(site));
  ASSERT_EQ(openings.size(), 1u);
  ASSERT_TRUE(openings[0].arc.has_value());
  EXPECT_NEAR(openings[0].arc->radius, radius, 0.05);
  EXPECT_NEAR(openings[0].arc->centre.v + openings[0].arc->radius, springing + rise, 0.004);
}

// A head that is neither level nor an arc nor a point, and that is drawn as one of them, says how far that is off.
TEST(ArchedTop, AHeadWithCutCornersStatesWhatItsDrawingIsOffBy) {
  const auto head = [](double u) {
    return std::min(2.9, 2.6 + 1.5 * ((kArchRight - kArchLeft) / 2 - std::abs(u - kMiddle)));
  };
  const FacadeSite site = test::scan_wall_open_where(
      [=](double u, double v) { return u > kArchLeft && u < kArchRight && v > kFoot && v < head(u); });
  const auto openings = find_openings(RaySamples(site));
  ASSERT_EQ(openings.size(), 1u);
  const FoundRectangle& found = openings[0];
  EXPECT_FALSE(found.pointed);
  double off = 0;  // mean distance along v, which is more than that across the head
  constexpr int kPlaces = 50;
  for (int i = 0; i < kPlaces; ++i) {
    const double u = kMiddle + (2 * (i + 0.5) / kPlaces - 1) * 0.9 * (kArchRight - kArchLeft) / 2;
    double v = found.at(Side::top);
    if (found.arc)
      v = found.arc->centre.v +
          std::sqrt(found.arc->radius * found.arc->radius - (u - found.arc->centre.u) * (u - found.arc->centre.u));
    off += std::abs(v - head(u)) / kPlaces;
  }
  EXPECT_GT(off, 0.01);
  EXPECT_LT(off, std::max(found.error(Side::top), found.side(Side::top).form));
}

}  // namespace
}  // namespace ilot
