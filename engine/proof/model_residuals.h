// SPDX-License-Identifier: Apache-2.0
// Judges models of buildings against the points of a cloud.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/polygon_model.h"

namespace ilot {

enum class EvaluatedFaces : std::uint8_t { all, roofs };

struct ModelResidualParams {
  EvaluatedFaces faces = EvaluatedFaces::all;
  double near_m = 0.2;         // distance up to which a point counts as near, inclusive
  double kept_share = 0.9;     // share of a building's points that the trimmed RMSE keeps: the nearest ones
  double metres_per_unit = 1;  // metres per unit of the coordinates
};

// The points that belong to one building. `model` is an index into the list of models, or kNoModel where the model of
// that building is missing.
struct BuildingPoints {
  std::string name;
  std::uint32_t model = 0;
  std::vector<Vec3> points;
};
constexpr std::uint32_t kNoModel = 0xffffffffu;

struct BuildingResidual {
  std::string name;
  std::uint64_t points = 0;
  std::uint64_t faces = 0;  // judged faces; 0 = the model is missing, and the values below are those of a failure
  double rmse_m = 0;        // distance of points to the model; infinite when it is missing
  double trimmed_rmse_m = 0;
  double near_share = 0;
  double largest_m = 0;
};

struct Percentiles {
  double p10 = 0, median = 0, p90 = 0, p95 = 0, largest = 0;
};

struct ModelResiduals {
  std::vector<BuildingResidual> buildings;                                    // in the order given
  std::uint64_t missing = 0;                                                  // buildings without a model
  std::uint64_t points = 0;                                                   // points of buildings that have a model
  double rmse_m = 0, trimmed_rmse_m = 0, near_share = 0;                      // over these points
  Percentiles building_rmse_m, building_trimmed_rmse_m, building_near_share;  // over all buildings, missing ones too
};

// Computes the distance from each point to the nearest point of its building's faces. Sums run over sorted distances,
// so the order of points has no effect. A percentile is a value that occurs: the smallest value that at least this
// share of the buildings does not exceed (for shares of near points, the p10 is the low end). Buildings are processed
// in parallel. Buildings without points are left out.
ModelResiduals evaluate_building_models(std::span<const PolygonModel> models, std::span<const BuildingPoints> buildings,
                                        const ModelResidualParams& params = {});

// Returns for each point the model whose plan is nearest within `margin` (closed, CRS units), or kNoModel. Ties: the
// first model. The plan of a model is the projection of its faces along z. O(log faces) per point, in parallel.
std::vector<std::uint32_t> assign_by_plan(std::span<const PolygonModel> models, std::span<const Vec3> points,
                                          double margin);

// Percentiles by the definition above; `values` are sorted in place. All are zero when there are no values.
Percentiles percentiles(std::vector<double> values);

}  // namespace ilot
