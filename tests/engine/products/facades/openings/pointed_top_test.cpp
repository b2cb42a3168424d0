// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/pointed_top.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "engine/products/facades/elements/facade_elements.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr double kHeadLeft = 2, kHeadRight = 3.2, kHeadFoot = 1, kHeadMiddle = (kHeadLeft + kHeadRight) / 2,
                 kHeadHalf = (kHeadRight - kHeadLeft) / 2;

// An opening between the jambs, from its foot to the given height at each place.
FacadeSite with_head(const std::function<double(double u)>& head) {
  return test::scan_wall_open_where(
      [=](double u, double v) { return u > kHeadLeft && u < kHeadRight && v > kHeadFoot && v < head(u); });
}

// Two arcs of this radius with centres on the springing line, which meet at the middle.
double pointed_arch(double u, double springing, double radius) {
  const double x = std::abs(u - kHeadMiddle) + radius - kHeadHalf;
  return springing + std::sqrt(std::max(0.0, radius * radius - x * x));
}

double gable_head(double u, double crown_u, double crown, double left, double right) {
  return crown + (u < crown_u ? left : right) * (u - crown_u);
}

FoundRectangle only_opening(const FacadeSite& site) {
  const auto openings = find_openings(RaySamples(site));
  EXPECT_EQ(openings.size(), 1u);
  return openings.empty() ? FoundRectangle{} : openings[0];
}

// The distance along v of the drawn ring from the head, at places between the jambs.
double largest_gap(const FacadeSite& site, const FoundRectangle& opening, const std::function<double(double)>& head) {
  const FacadeElement e = element_of(site, {opening, ElementKind::window, 0, 0, 0, {}});
  double largest = 0;
  for (int i = 1; i < 20; ++i) {
    const double u = kHeadLeft + (kHeadRight - kHeadLeft) * i / 20;
    double top = -1;
    for (std::size_t c = 0; c < e.ring.size(); ++c) {
      const Vec3 a = e.ring[c], b = e.ring[(c + 1) % e.ring.size()];
      if ((a.x < u) == (b.x < u)) continue;
      top = std::max(top, a.z + (b.z - a.z) * (u - a.x) / (b.x - a.x));
    }
    largest = std::max(largest, std::abs(top - head(u)));
  }
  return largest;
}

TEST(PointedTop, ArchesFromLowToLancets) {
  for (const double radius : {1.5 * kHeadHalf, 2 * kHeadHalf, 2.4 * kHeadHalf}) {
    const auto head = [=](double u) { return pointed_arch(u, 2.2, radius); };
    const FacadeSite site = with_head(head);
    const FoundRectangle opening = only_opening(site);
    ASSERT_TRUE(opening.pointed) << radius;
    EXPECT_FALSE(opening.arc);
    EXPECT_NEAR(opening.pointed->radius, radius, 0.04 * radius);
    EXPECT_NEAR(opening.at(Side::top), head(kHeadMiddle), 0.01);
    EXPECT_NEAR(springing_of(opening, Side::left), 2.2, 0.1) << "a tangent of the jamb ends where its error begins";
    const double off = std::max(opening.error(Side::top), opening.side(Side::top).form);
    EXPECT_LT(off, 0.05);
  }
}

TEST(PointedTop, AGableWhoseRidgeIsNotInTheMiddle) {
  const auto head = [](double u) { return gable_head(u, 2.4, 2.9, 0.9, -0.45); };
  const FoundRectangle opening = only_opening(with_head(head));
  ASSERT_TRUE(opening.pointed);
  EXPECT_EQ(opening.pointed->radius, 0);
  EXPECT_NEAR(opening.pointed->left_slope, 0.9, 0.05);
  EXPECT_NEAR(opening.pointed->right_slope, -0.45, 0.02);
  EXPECT_NEAR(opening.at(Side::top), 2.9, 0.01);
  EXPECT_NEAR(springing_of(opening, Side::right), head(kHeadRight), 0.01);
}

TEST(PointedTop, TheRingFollowsTheHead) {
  const auto arch = [](double u) { return pointed_arch(u, 2.2, 2 * kHeadHalf); };
  const auto roof = [](double u) { return gable_head(u, kHeadMiddle, 2.9, 0.8, -0.8); };
  for (const std::function<double(double)>& head : {std::function<double(double)>(arch), {roof}}) {
    const FacadeSite site = with_head(head);
    EXPECT_LT(largest_gap(site, only_opening(site), head), 0.03);
  }
}

TEST(PointedTop, OtherHeadsStayWhatTheyAre) {
  const double radius = kHeadHalf;
  EXPECT_FALSE(only_opening(with_head([](double) { return 3.0; })).pointed) << "level";
  const auto round = [=](double u) {
    return 2.2 + std::sqrt(std::max(0.0, radius * radius - (u - kHeadMiddle) * (u - kHeadMiddle)));
  };
  const FoundRectangle arch = only_opening(with_head(round));
  EXPECT_TRUE(arch.arc);
  EXPECT_FALSE(arch.pointed);
  const FoundRectangle slope = only_opening(with_head([](double u) { return 2.4 + 0.4 * (u - kHeadLeft); }));
  EXPECT_FALSE(slope.pointed) << "one line is a leaning side";
}

// A level head of which a lamp hides the middle, and one with a notch in a corner.
TEST(PointedTop, AStepIsNoPoint) {
  EXPECT_FALSE(only_opening(with_head([](double u) { return u < 2.4 ? 2.7 : 3.0; })).pointed);
  EXPECT_FALSE(only_opening(with_head([](double u) { return std::abs(u - kHeadMiddle) < 0.25 ? 3.0 : 2.7; })).pointed);
}

}  // namespace
}  // namespace ilot
