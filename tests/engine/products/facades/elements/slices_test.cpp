// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/slices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/sampled_site.h"

namespace ilot {
namespace {

using test::SampledSite;

// A window: reveals of 25 cm, the frame and its pane at the end, a room's back behind.
TEST(Slices, TheRatioPeaksWhereASheetFillsTheOpening) {
  SampledSite s(4, 4, 0.012, 0.001);
  s.sheet(1, 2, 1, 2.5, -0.25, 2);
  for (const double u : {1.0, 2.0}) s.face({u, 1, -0.25}, {0, 0, 0.25}, {0, 1.5, 0}, 3);
  s.sheet(1, 2, 1, 2.5, -0.8, 4);
  const RaySamples samples(s.site);
  const auto slices = slices_of(samples, {Box2{1, 2, 1, 2.5}.grown(0.05), -1, -0.01});
  ASSERT_GT(slices.size(), 10u);
  const auto end = end_slice(slices);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->w, -0.25, 0.011);
  EXPECT_NEAR(end->extent.u0, 1, 0.015);
  EXPECT_NEAR(end->extent.v1, 2.5, 0.015);
  for (const FacadeSlice& cut : slices) {
    EXPECT_LE(cut.boundary, cut.points);
    if (std::abs(cut.w + 0.25) > 0.03 && std::abs(cut.w + 0.8) > 0.03) {
      EXPECT_LT(cut.ratio(), 2.5) << cut.w;
      EXPECT_LT(3 * cut.ratio(), end->ratio()) << cut.w;
    }
  }
}

// Of 250,000 points of a sheet one in eight is looked at: the same cut is the end, its extent is that of all points.
TEST(Slices, OfMorePointsThanAreLookedAt) {
  SampledSite s(4, 4, 0.003, 0.001);
  s.sheet(1, 2.5, 1, 2.5, -0.25, 2);
  s.sheet(1, 2.5, 1, 2.5, -0.8, 4);
  const RaySamples samples(s.site);
  const SliceRange range{Box2{1, 2.5, 1, 2.5}.grown(0.05), -1, -0.01};
  const auto end = end_slice(slices_of(samples, range));
  ASSERT_TRUE(end);
  EXPECT_EQ(end->level, 3);
  EXPECT_NEAR(end->w, -0.25, 0.011);
  EXPECT_GT(end->points, 240000u);
  EXPECT_GT(end->ratio(), 10);
  std::vector<double> u;
  for (const FacadePoint& p : s.site.points)
    if (std::abs(static_cast<double>(p.w) - end->w) <= 0.015) u.push_back(p.u);
  ASSERT_EQ(u.size(), end->points);
  std::sort(u.begin(), u.end());
  const Box2 extent = whole_extent(samples, range, *end);
  EXPECT_EQ(extent.u0, u[static_cast<std::size_t>(0.005 * static_cast<double>(u.size() - 1))]);
  EXPECT_EQ(extent.u1, u[static_cast<std::size_t>(0.995 * static_cast<double>(u.size() - 1))]);
}

TEST(Slices, NoPointsNoSlices) {
  const SampledSite s(4, 4, 0.1, 0.001);
  const RaySamples samples(s.site);
  const auto slices = slices_of(samples, {{1, 2, 1, 2}, -1, 1});
  EXPECT_TRUE(slices.empty());
  EXPECT_FALSE(end_slice(slices));
}

}  // namespace
}  // namespace ilot
