// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/irregularities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/sampled_site.h"

namespace ilot {
namespace {

using test::SampledSite;

constexpr double kRadius = 0.5;

double height_of_cap(double u, double v, double rise) {
  const double r2 = (u - 2) * (u - 2) + (v - 2) * (v - 2);
  return rise * std::max(0.0, 1 - r2 / (kRadius * kRadius));
}

// A wall that bulges, a sill of 5 cm and a hole beside it.
FacadeSite bulging(double rise) {
  SampledSite s(6, 4, 0.015, 0.002);
  s.wall_around(4, 5, 1, 2.5);
  FacadeSite site = s.site;
  for (FacadePoint& p : site.points) p.w += static_cast<float>(height_of_cap(p.u, p.v, rise));
  SampledSite sill(6, 4, 0.015, 0.002, 9);
  sill.sheet(3.9, 5.1, 0.8, 1, 0.05, 2);
  std::erase_if(site.points, [](const FacadePoint& p) { return p.u > 3.9F && p.u < 5.1F && p.v > 0.8F && p.v < 1; });
  site.points.insert(site.points.end(), sill.site.points.begin(), sill.site.points.end());
  return site;
}

TEST(Irregularities, ABulgeIsOneAndASillAndAHoleAreNone) {
  for (const double rise : {0.03, 0.06, -0.03}) {
    const FacadeSite site = bulging(rise);
    const auto found = find_irregularities(RaySamples(site), {});
    ASSERT_EQ(found.size(), 1u) << rise;
    const Irregularity& one = found[0];
    EXPECT_NEAR(one.rise, rise, 0.005) << rise;
    EXPECT_GT(one.density, 0.9) << rise;
    double off = 0;
    for (const Vec3& p : one.vertices) off += std::pow(p.z - height_of_cap(p.x, p.y, rise), 2);
    EXPECT_LT(std::sqrt(off / static_cast<double>(one.vertices.size())), 0.003) << rise;
    for (const Place2& p : one.ring) EXPECT_LT(std::hypot(p.u - 2, p.v - 2), kRadius + 0.08) << rise;
    double area = 0;
    for (const auto& t : one.triangles) {
      const Vec3 a = one.vertices[t[0]], b = one.vertices[t[1]], c = one.vertices[t[2]];
      const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      EXPECT_GT(twice, 0);
      area += twice / 2;
    }
    EXPECT_GT(area, 0.7 * 3.14159 * kRadius * kRadius) << rise;
    EXPECT_LT(area, 1.3 * 3.14159 * kRadius * kRadius) << rise;
  }
}

TEST(Irregularities, WhatIsTakenIsNone) {
  const FacadeSite site = bulging(0.04);
  EXPECT_TRUE(find_irregularities(RaySamples(site), {{1.3, 2.7, 1.3, 2.7}}).empty());
}

TEST(Irregularities, AnEvenWallHasNone) {
  SampledSite s(6, 4, 0.015, 0.003);
  s.sheet(0, 6, 0, 4, 0, 1);
  EXPECT_TRUE(find_irregularities(RaySamples(s.site), {}).empty());
}

TEST(Irregularities, DoNotDependOnTheOrderOfPoints) {
  FacadeSite site = bulging(0.04);
  const auto before = find_irregularities(RaySamples(site), {});
  std::reverse(site.points.begin(), site.points.end());
  const auto after = find_irregularities(RaySamples(site), {});
  ASSERT_EQ(before.size(), after.size());
  ASSERT_EQ(before[0].vertices.size(), after[0].vertices.size());
  for (std::size_t i = 0; i < before[0].vertices.size(); ++i) {
    EXPECT_EQ(before[0].vertices[i].x, after[0].vertices[i].x);
    EXPECT_EQ(before[0].vertices[i].z, after[0].vertices[i].z);
  }
  EXPECT_EQ(before[0].triangles, after[0].triangles);
}

}  // namespace
}  // namespace ilot
