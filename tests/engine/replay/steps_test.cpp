// SPDX-License-Identifier: Apache-2.0
// Who looks at the steps of a building changes nothing, and what is seen is what the model is made from.
#include <cmath>

#include "engine/products/roofs/solids/roof_model.h"
#include "engine/replay/building_shapes.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

RoofSite gable() {
  return test::roof_site(10, 8, [](double, double y) { return 6 - 0.6 * std::abs(y - 4); });
}

TEST(RoofSteps, AModelIsTheSameWhetherSomebodyLooksOrNot) {
  const RoofSite site = gable();
  const SolidCheck pass = [](const Building&) { return std::string(); };
  RoofSteps steps;
  const RoofModel a = model_roof(site, {}, 1), b = model_roof(site, {}, 1, pass, &steps);
  ASSERT_EQ(a.lod22.vertices.size(), b.lod22.vertices.size());
  for (std::size_t i = 0; i < a.lod22.vertices.size(); ++i)
    EXPECT_EQ(norm(a.lod22.vertices[i] - b.lod22.vertices[i]), 0);
  EXPECT_EQ(a.face_of_point, b.face_of_point);
  EXPECT_EQ(steps.planes.planes.size(), 2u);
  EXPECT_EQ(steps.planes.of_point.size(), site.points.size());
  EXPECT_FALSE(steps.lines.empty());
  EXPECT_EQ(steps.label.size(), steps.cells.regions);
  EXPECT_EQ(steps.cell_of_point.size(), site.points.size());
  EXPECT_EQ(steps.faces.regions, 2u);
  EXPECT_TRUE(steps.refused.empty());
}

TEST(RoofSteps, HullsHoldThePointsOfTheirPlanes) {
  SiteSteps steps;
  steps.gathered.site = gable();
  for (const Vec3& p : steps.gathered.site.points)
    if (p.y < 0.4) steps.gathered.site.beside.push_back(p + Vec3{0, -0.4, -0.6 * 0.4});
  model_roof(
      steps.gathered.site, {}, 1, [](const Building&) { return std::string(); }, &steps.roof);
  const std::vector<SitePolygon> hulls = plane_hulls(steps);
  ASSERT_EQ(hulls.size(), 2u);
  for (const SitePolygon& hull : hulls) {
    ASSERT_EQ(hull.size(), 1u);
    EXPECT_GT(hull[0].size(), 3u);
    for (const Point2 p : hull[0]) {
      EXPECT_TRUE(p.x >= 0 && p.x <= 10000) << p.x;
      EXPECT_TRUE(p.y >= -400 && p.y <= 8000) << p.y;
    }
  }
}

}  // namespace
}  // namespace ilot
