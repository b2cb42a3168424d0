// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/sparse_panes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr Vec3 kPaneEye{1, 1.5, 8};
constexpr double kPaneStep = 0.004;  // tangent
constexpr Box2 kPane{2, 3.1, 1.2, 2.8};

// A flat wall, of whose points those are kept that `share` keeps by chance.
FacadeSite thinned(const std::function<double(double, double)>& share, Vec3 eye = kPaneEye, double step = kPaneStep) {
  test::ScannedWall wall;
  wall.wall({});
  FacadeSite site = test::scan_wall(wall, eye, step);
  Rng rng(5);
  std::erase_if(site.points, [&](const FacadePoint& p) { return rng.uniform() >= share(p.u, p.v); });
  return site;
}

FacadeSite with_pane(double share) {
  return thinned([=](double u, double v) { return kPane.contains({u, v}) ? share : 1; });
}

std::vector<FoundRectangle> panes_of(const FacadeSite& site) {
  return find_sparse_panes(RaySamples(site), 0.3);
}

void expect_the_pane(const std::vector<FoundRectangle>& found) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at(Side::left), kPane.u0, found[0].error(Side::left));
  EXPECT_NEAR(found[0].at(Side::right), kPane.u1, found[0].error(Side::right));
  EXPECT_NEAR(found[0].at(Side::bottom), kPane.v0, found[0].error(Side::bottom));
  EXPECT_NEAR(found[0].at(Side::top), kPane.v1, found[0].error(Side::top));
  for (const Side side : kSides) {
    EXPECT_LT(found[0].error(side), 0.06);
    EXPECT_GT(found[0].side(side).form, found[0].error(side));  // a frame may lie about the glass
  }
  EXPECT_TRUE(found[0].few_echoes);
}

TEST(SparsePanes, GlassThatSendsBackATenthToAThird) {
  for (const double share : {0.1, 0.2, 0.33}) {
    SCOPED_TRACE(share);
    expect_the_pane(panes_of(with_pane(share)));
  }
}

TEST(SparsePanes, TheOrderOfPointsChangesNothing) {
  FacadeSite site = with_pane(0.2);
  const std::vector<FoundRectangle> found = panes_of(site);
  std::reverse(site.points.begin(), site.points.end());
  const std::vector<FoundRectangle> again = panes_of(site);
  ASSERT_EQ(found.size(), again.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Side side : kSides) {
      EXPECT_EQ(found[i].at(side), again[i].at(side));
      EXPECT_EQ(found[i].error(side), again[i].error(side));
    }
}

TEST(SparsePanes, AHoleAndAWallAreNone) {
  EXPECT_TRUE(panes_of(with_pane(0)).empty());
  EXPECT_TRUE(panes_of(with_pane(0.8)).empty());
  EXPECT_TRUE(panes_of(with_pane(1)).empty());
}

TEST(SparsePanes, ADensityThatFallsAlongTheWallIsNone) {
  EXPECT_TRUE(panes_of(thinned([](double u, double) { return 1 / (1 + u); })).empty());
  EXPECT_TRUE(panes_of(thinned([](double u, double) { return 0.1 + std::abs(u - 3) / 3; })).empty());
}

// What is hidden from one of two stations has half of the points: the other one sees the wall there.
TEST(SparsePanes, TheShadowOfOneStationIsNone) {
  const FacadeSite first = thinned([](double u, double v) { return kPane.contains({u, v}) ? 0.0 : 1; });
  const FacadeSite second = thinned([](double, double) { return 0.3; }, {5, 1.5, 8});
  FacadeSite site = test::joined(first, second);
  site.from.assign(first.points.size(), 1);
  site.from.resize(site.points.size(), 2);
  EXPECT_TRUE(panes_of(site).empty());
}

// A railing before the wall takes as many rays as are missing behind it.
TEST(SparsePanes, WhatStandsBeforeTheWallExplainsIt) {
  FacadeSite site = with_pane(0.3);
  const FacadeSite all = with_pane(1);
  for (const FacadePoint& p : all.points) {
    if (!kPane.contains({p.u, p.v})) continue;
    const double on = (kPaneEye.z - 1) / kPaneEye.z;
    if (site.points.size() % 2 == 0)
      site.points.push_back({static_cast<float>(kPaneEye.x + (p.u - kPaneEye.x) * on),
                             static_cast<float>(kPaneEye.y + (p.v - kPaneEye.y) * on), 1, 0});
    else
      site.points.push_back(p), site.points.back().w = 1;
  }
  EXPECT_TRUE(panes_of(site).empty());
}

TEST(SparsePanes, AWidePierPartsTwoPanesAndABarDoesNot) {
  constexpr Box2 kWide{1.5, 3.5, 1.2, 2.8};
  const auto parted_by = [&](double width) {
    return panes_of(thinned([=](double u, double v) {
      return kWide.contains({u, v}) && std::abs(u - 2.5) > width / 2 ? 0.2 : 1;
    }));
  };
  EXPECT_EQ(parted_by(0.05).size(), 1u);
  EXPECT_EQ(parted_by(0.4).size(), 2u);
}

TEST(SparsePanes, ASlantingSideIsThatOfAShadow) {
  EXPECT_TRUE(panes_of(thinned([](double u, double v) {
                return v > 1 && v < 2.8 && u > 2.4 && u < 2.4 + 1.2 * std::min(1.0, (2.8 - v) / 1.1) ? 0.2 : 1;
              })).empty());
}

TEST(SparsePanes, ADoorBeginsAtTheFootAndAFenceCastsNoDoor) {
  const auto up_to = [](double top) {
    return panes_of(thinned([=](double u, double v) { return u > 2 && u < 3.1 && v < top ? 0.2 : 1; }));
  };
  const std::vector<FoundRectangle> door = up_to(2.2);
  ASSERT_EQ(door.size(), 1u);
  EXPECT_EQ(door[0].side(Side::bottom).status, DrawnStatus::occluded);
  EXPECT_TRUE(up_to(1.2).empty());
}

TEST(SparsePanes, TheyReplacePiecesAndYieldToWhatWasFoundOtherwise) {
  const auto box = [](double u0, double u1, double v0, double v1) {
    FoundRectangle r;
    r.side(Side::left).at = u0, r.side(Side::right).at = u1, r.side(Side::bottom).at = v0, r.side(Side::top).at = v1;
    return r;
  };
  std::vector<FoundRectangle> found{box(0.1, 0.4, 0.1, 0.5), box(2.05, 3.1, 0, 1.6), box(5, 5.4, 0, 1)};
  add_sparse_panes({box(0, 1, 0, 1.6), box(2, 3, 0, 1.5)}, found);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].at(Side::left), 2.05);
  EXPECT_EQ(found[1].at(Side::left), 5);
  EXPECT_EQ(found[2].at(Side::right), 1);
}

}  // namespace
}  // namespace ilot
