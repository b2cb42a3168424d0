// SPDX-License-Identifier: Apache-2.0
// Reports the residuals of models as text for people and as JSON for programs.
#pragma once
#include <string>

#include "engine/proof/model_points.h"
#include "engine/proof/model_residuals.h"

namespace ilot {

struct ModelEvaluation {
  std::string models, cloud;  // as the user named them
  ModelPoints points;         // positions are no longer needed
  ModelResiduals residuals;
  ModelResidualParams params;
};

std::string model_text(const ModelEvaluation& evaluation);

// JSON with these keys: models, cloud, points_of, faces, points.{read,judged,unassigned},
// buildings.{judged,missing,without_points}, over_points.{rmse_m,trimmed_rmse_m,near_share},
// over_buildings.{rmse_m,trimmed_rmse_m,near_share} each with p10, median, p90, p95, largest; list[] of
// {name,points,faces,rmse_m,trimmed_rmse_m,near_share,largest_m}. The distances of a missing model are null.
std::string model_json(const ModelEvaluation& evaluation);

}  // namespace ilot
