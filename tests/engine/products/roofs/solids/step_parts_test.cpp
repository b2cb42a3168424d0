// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/step_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/products/roofs/solids/roof_model.h"
#include "engine/validity/validity.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;

// A hall of 5 m, a house of 6 m under a gable of 2 m, a tower of 15 m.
double town_hall(double x, double y) {
  if (x < 8) return 5;
  return x < 16 ? 6 + std::min(y, 8 - y) / 2 : 15;
}

std::vector<double> heights_of(const Building& b) {
  std::vector<double> heights;
  for (const BuildingSurface& s : b.surfaces)
    if (s.kind == SurfaceKind::roof) {
      for (const std::uint32_t v : s.rings[0])
        EXPECT_EQ(b.vertices[v].z, b.vertices[s.rings[0][0]].z) << "a part is level";
      heights.push_back(b.vertices[s.rings[0][0]].z);
    }
  std::sort(heights.begin(), heights.end());
  return heights;
}

RoofModel model_with_step(double step) {
  RoofModelParams params;
  params.lod13_step = step;
  return model_roof(roof_site(20, 8, town_hall), params, 1);
}

TEST(StepParts, TheDefaultStepJoinsWhatLiesWithinThreeMetres) {
  const RoofModel m = model_with_step(3);
  const std::vector<double> heights = heights_of(m.lod13);
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(heights[1], 15, 0.1);
  EXPECT_TRUE(validate_building(m.lod13, m.lod13.vertices.front(), 0.0001).empty());
}

TEST(StepParts, ASmallerStepKeepsMoreParts) {
  const RoofModel m = model_with_step(1.5);
  const std::vector<double> heights = heights_of(m.lod13);
  ASSERT_EQ(heights.size(), 3u);
  EXPECT_NEAR(heights[0], 5, 0.1);
  EXPECT_NEAR(heights[1], 7.4, 0.15) << "70 % of the points of a gable of 2 m lie lower";
  EXPECT_TRUE(validate_building(m.lod13, m.lod13.vertices.front(), 0.0001).empty());
}

TEST(StepParts, ALargeStepGivesTheBlock) {
  const RoofModel m = model_with_step(50);
  EXPECT_EQ(m.lod13.lod, "1.3");
  ASSERT_EQ(m.lod13.vertices.size(), m.lod12.vertices.size());
  for (std::size_t i = 0; i < m.lod12.vertices.size(); ++i) EXPECT_EQ(m.lod13.vertices[i].z, m.lod12.vertices[i].z);
  EXPECT_TRUE(model_with_step(0).lod13.surfaces.empty());
}

// Parts of every step: no two that share an edge differ by less, and each has the quantile of its own points.
TEST(StepParts, PartsDifferByAStepAndHaveTheHeightsOfTheirPoints) {
  const RoofModel m = model_with_step(3);
  const RoofSite site = roof_site(20, 8, town_hall);
  for (const double step : {0.2, 1.0, 3.0, 7.0, 12.0}) {
    const StepParts parts = step_parts(m.map.faces, m.map.planes, site.outline, site.points, {step, 0.7});
    ASSERT_EQ(parts.parts.regions, parts.planes.size());
    for (const PartitionEdge& e : parts.parts.edges) {
      if (e.left == kOutside || e.right == kOutside) continue;
      EXPECT_GE(std::abs(parts.planes[e.left - 1].c - parts.planes[e.right - 1].c), step);
    }
    std::vector<FlatPoint> flat;
    for (const Vec3& p : site.points) flat.push_back({p.x * 1000, p.y * 1000});
    const std::vector<std::uint32_t> region = regions_of(parts.parts, flat);
    std::map<std::uint32_t, std::vector<double>> z;
    for (std::size_t i = 0; i < region.size(); ++i)
      if (region[i] != kOutside) z[region[i]].push_back(site.points[i].z);
    for (auto& [part, heights] : z) {
      const auto below =
          std::count_if(heights.begin(), heights.end(), [&](double h) { return h <= parts.planes[part - 1].c; });
      EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(heights.size()), 0.7, 0.02) << step;
    }
  }
}

}  // namespace
}  // namespace ilot
