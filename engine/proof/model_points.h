// SPDX-License-Identifier: Apache-2.0
// Assigns the points of a cloud to buildings.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/proof/model_residuals.h"

namespace ilot {

// automatic: by the field `building` where most of its values are names of models; otherwise all points where there is
// one model; otherwise by plan.
enum class PointOwner : std::uint8_t { automatic, field, plan, everything };

struct ModelPointsParams {
  PointOwner owner = PointOwner::automatic;
  std::string field = "building";     // integer extra bytes; value N belongs to the model named N or building-N
  double margin_m = 0.5;              // by plan: how far outside a model's plan a point may lie
  std::optional<int> classification;  // only points of this class
};

struct ModelPoints {
  std::vector<BuildingPoints> buildings;     // by model, then buildings without a model by ascending value of the field
  PointOwner owner = PointOwner::automatic;  // the rule that was used
  std::uint64_t read = 0;                    // points of the class asked for
  std::uint64_t unassigned = 0;              // of these, points that belong to no building
  std::uint64_t models_without_points = 0;
  double metres_per_unit = 1;
};

// Reads a cloud. Throws Error when it cannot be read or lacks the field asked for. 32 bytes per point.
ModelPoints read_model_points(const std::filesystem::path& cloud, std::span<const PolygonModel> models,
                              const ModelPointsParams& params = {});

}  // namespace ilot
