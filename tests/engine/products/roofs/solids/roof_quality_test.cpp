// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;

double level_five(double, double) {
  return 5;
}

PointMeasures measured(const RoofSite& site, const RoofModel& model) {
  PointMeasures measures(site, model, 1);
  for (std::size_t i = 0; i < site.points.size(); ++i)
    measures.add(site.points[i], i < model.face_of_point.size() ? model.face_of_point[i] : 0);
  return measures;
}

TEST(RoofQuality, AFlatRoofIsGood) {
  const RoofSite site = roof_site(12, 8, level_five);
  const RoofModel model = model_roof(site, {}, 1);
  PointMeasures m = measured(site, model);
  EXPECT_NEAR(m.rmse(), 0.02, 0.004) << "the noise";
  EXPECT_LE(m.quantile(0.95), 0.036) << "the noise is uniform and ends at 3.5 cm";
  EXPECT_EQ(m.explained(), 1);
  EXPECT_EQ(m.bare_share(), 0);
  EXPECT_EQ(m.largest_off(), 0);
  EXPECT_LT(m.overshoot(), 0.05);
  EXPECT_STREQ(m.verdict(model.status).quality, "good");
  EXPECT_EQ(m.verdict(model.status).reason, "");
}

// The points of a part that the model does not have count although no face has them.
TEST(RoofQuality, APartThatTheModelLacksIsFound) {
  const RoofModel model = model_roof(roof_site(12, 8, level_five), {}, 1);
  const auto tower = [](double x, double y) { return x < 3 && y < 2 ? 8.0 : 5.0; };
  const RoofSite site = roof_site(12, 8, tower);
  PointMeasures m(site, model, 1);
  for (const Vec3& p : site.points) m.add(p, p.z > 7 ? 0 : model.lod22.surfaces[0].plane_id);
  EXPECT_NEAR(m.rmse(), std::sqrt(9 * 6 / 96.0), 0.15) << "6 of 96 m2 are 3 m off";
  EXPECT_NEAR(m.explained(), 1 - 6 / 96.0, 0.02);
  EXPECT_NEAR(m.largest_off(), 6, 1);
  EXPECT_STREQ(m.verdict(model.status).quality, "check");
  EXPECT_NE(m.verdict(model.status).reason, "");
}

// Twelve points in a hundred, spread over the whole roof, stand 1.4 m above it: no 2 m2 in one place and less than 15
// %.
TEST(RoofQuality, AFewPointsFarOffAreSeen) {
  const RoofModel model = model_roof(roof_site(12, 8, level_five), {}, 1);
  RoofSite site = roof_site(12, 8, level_five);
  for (std::size_t i = 0; i < site.points.size(); ++i)
    if (i % 25 < 3) site.points[i].z += 1.4;
  PointMeasures m(site, model, 1);
  for (const Vec3& p : site.points) m.add(p, p.z > site.points[5].z + 1 ? 0 : model.lod22.surfaces[0].plane_id);
  EXPECT_NEAR(m.explained(), 0.88, 0.01);
  EXPECT_LT(m.step(), 0.5);
  EXPECT_NEAR(m.quantile(0.95), 1.4, 0.05);
  EXPECT_STREQ(m.verdict(model.status).quality, "check");
  EXPECT_EQ(m.verdict(model.status).reason.substr(0, 33), "5 % of the points lie farther tha");
}

TEST(RoofQuality, ARoofWithoutPointsIsSeen) {
  RoofSite site = roof_site(12, 8, level_five);
  const RoofModel model = model_roof(site, {}, 1);
  std::erase_if(site.points, [](Vec3 p) { return p.x > 7; });
  PointMeasures m(site, model, 1);
  for (const Vec3& p : site.points) m.add(p, 1);
  EXPECT_NEAR(m.bare_share(), 4.0 / 12, 0.06) << "beyond 1 m from the last points";
  EXPECT_STREQ(m.verdict(model.status).quality, "check");
}

TEST(RoofQuality, AFaceAboveAllPointsIsSeen) {
  const RoofModel model = model_roof(roof_site(12, 8, [](double x, double) { return x > 9 ? 9.0 : 5.0; }), {}, 1);
  const RoofSite site = roof_site(12, 8, level_five);
  PointMeasures m(site, model, 1);
  for (const Vec3& p : site.points) m.add(p, 0);
  EXPECT_NEAR(m.overshoot(), 4, 0.1);
  EXPECT_STREQ(m.verdict(model.status).quality, "bad");
}

TEST(RoofQuality, WithoutASolidNothingIsMeasured) {
  RoofSite site = roof_site(12, 8, level_five);
  site.points.resize(2);
  const RoofModel model = model_roof(site, {}, 1);
  PointMeasures m = measured(site, model);
  EXPECT_FALSE(m.measured());
  EXPECT_TRUE(std::isnan(m.rmse()));
  EXPECT_STREQ(m.verdict(model.status).quality, "bad");
}

}  // namespace
}  // namespace ilot
