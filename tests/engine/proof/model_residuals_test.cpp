// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/model_residuals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

// A flat roof of 10 x 10 m at height 5 with its floor.
PolygonModel slab(const std::string& name, double x0) {
  return {name,
          {{x0, 0, 5},
           {x0 + 10, 0, 5},
           {x0 + 10, 10, 5},
           {x0, 10, 5},
           {x0, 0, 0},
           {x0 + 10, 0, 0},
           {x0 + 10, 10, 0},
           {x0, 10, 0}},
          {{{{0, 1, 2, 3}}, FaceKind::unknown, 0}, {{{7, 6, 5, 4}}, FaceKind::unknown, 0}}};
}

TEST(ModelResiduals, MeasuresByHand) {
  const std::vector<PolygonModel> models{slab("a", 0)};
  BuildingPoints building{"a", 0, {}};
  for (int i = 0; i < 9; ++i) building.points.push_back({1.0 + i, 5, 5.1});
  building.points.push_back({5, 5, 6});
  const ModelResiduals r = evaluate_building_models(models, std::span(&building, 1));
  ASSERT_EQ(r.buildings.size(), 1u);
  EXPECT_EQ(r.buildings[0].points, 10u);
  EXPECT_EQ(r.buildings[0].faces, 2u);
  EXPECT_NEAR(r.buildings[0].rmse_m, std::sqrt((9 * 0.01 + 1) / 10), 1e-12);
  EXPECT_NEAR(r.buildings[0].trimmed_rmse_m, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(r.buildings[0].near_share, 0.9);
  EXPECT_NEAR(r.buildings[0].largest_m, 1, 1e-12);
  EXPECT_EQ(r.rmse_m, r.buildings[0].rmse_m);
}

TEST(ModelResiduals, MissingModelsAreFailuresInThePercentiles) {
  const std::vector<PolygonModel> models{slab("a", 0), slab("b", 20), {"empty", {}, {}}};
  const std::vector<BuildingPoints> buildings{{"a", 0, {{1, 1, 5}}},
                                              {"b", 1, {{21, 1, 5}}},
                                              {"empty", 2, {{90, 1, 5}}},
                                              {"stranger", kNoModel, {{99, 9, 9}}},
                                              {"without points", 0, {}}};
  const ModelResiduals r = evaluate_building_models(models, buildings);
  EXPECT_EQ(r.buildings.size(), 4u);
  EXPECT_EQ(r.missing, 2u);
  EXPECT_EQ(r.points, 2u);
  EXPECT_EQ(r.rmse_m, 0);
  EXPECT_EQ(r.building_rmse_m.median, 0);
  EXPECT_TRUE(std::isinf(r.building_rmse_m.p90));
  EXPECT_EQ(r.building_near_share.p10, 0);
  EXPECT_EQ(r.building_near_share.largest, 1);
}

TEST(ModelResiduals, RoofsAlone) {
  const std::vector<PolygonModel> models{slab("a", 0)};
  const BuildingPoints low{"a", 0, {{5, 5, 1}}};
  EXPECT_NEAR(evaluate_building_models(models, std::span(&low, 1)).rmse_m, 1, 1e-12);
  ModelResidualParams params;
  params.faces = EvaluatedFaces::roofs;
  EXPECT_NEAR(evaluate_building_models(models, std::span(&low, 1), params).rmse_m, 4, 1e-12);
  params.metres_per_unit = 0.5;
  EXPECT_NEAR(evaluate_building_models(models, std::span(&low, 1), params).rmse_m, 2, 1e-12);
}

TEST(ModelResiduals, AssignsByPlanWithinTheMargin) {
  const std::vector<PolygonModel> models{slab("a", 0), slab("b", 20)};
  const std::vector<Vec3> points{{5, 5, 99}, {25, 5, -99}, {10.5, 5, 0}, {10.51, 5, 0}, {15, 5, 0}, {19.6, 5, 0}};
  const std::vector<std::uint32_t> wanted{0, 1, 0, kNoModel, kNoModel, 1};
  EXPECT_EQ(assign_by_plan(models, points, 0.5), wanted);
  const std::vector<PolygonModel> twice{slab("a", 0), slab("over it", 5)};
  EXPECT_EQ(assign_by_plan(twice, std::vector<Vec3>{{7, 5, 0}}, 0.5), std::vector<std::uint32_t>{0});
  EXPECT_EQ(assign_by_plan({}, points, 0.5), std::vector<std::uint32_t>(6, kNoModel));
}

TEST(ModelResiduals, DoesNotDependOnOrderOrThreads) {
  const std::vector<PolygonModel> models{slab("a", 0), slab("b", 20)};
  std::vector<BuildingPoints> buildings{{"a", 0, {}}, {"b", 1, {}}};
  Rng rng(4);
  for (int i = 0; i < 3000; ++i) {
    const double x = rng.uniform(), y = rng.uniform(), z = rng.uniform();
    buildings[static_cast<std::size_t>(i % 2)].points.push_back({20.0 * (i % 2) + 10 * x, 10 * y, 4 + 2 * z});
  }
  ModelResiduals one, three;
  with_threads(1, [&] { one = evaluate_building_models(models, buildings); });
  for (BuildingPoints& b : buildings) std::reverse(b.points.begin(), b.points.end());
  with_threads(3, [&] { three = evaluate_building_models(models, buildings); });
  EXPECT_EQ(one.rmse_m, three.rmse_m);
  EXPECT_EQ(one.trimmed_rmse_m, three.trimmed_rmse_m);
  EXPECT_EQ(one.near_share, three.near_share);
  EXPECT_EQ(one.buildings[1].rmse_m, three.buildings[1].rmse_m);
}

TEST(ModelResiduals, PercentilesAreValuesThatOccur) {
  std::vector<double> values;
  for (int i = 20; i > 0; --i) values.push_back(i);
  const Percentiles p = percentiles(values);
  EXPECT_EQ(p.p10, 2);
  EXPECT_EQ(p.median, 10);
  EXPECT_EQ(p.p90, 18);
  EXPECT_EQ(p.p95, 19);
  EXPECT_EQ(p.largest, 20);
  EXPECT_EQ(percentiles({7}).p10, 7);
  EXPECT_EQ(percentiles({}).median, 0);
}

}  // namespace
}  // namespace ilot
