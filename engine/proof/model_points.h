// SPDX-License-Identifier: Apache-2.0
// Which points of a cloud belong to which building.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/proof/model_residuals.h"

namespace ilot {

// automatic: by the field `building`, where most of its values are names of models; else everything, where there is one
// model; else by plan.
enum class PointOwner : std::uint8_t { automatic, field, plan, everything };

struct ModelPointsParams {
  PointOwner owner = PointOwner::automatic;
  std::string field = "building";     // whole-number extra bytes; value N is of the model named N or building-N
  double margin_m = 0.5;              // by plan: how far outside a model's plan a point may lie
  std::optional<int> classification;  // only points of this class
};

struct ModelPoints {
  std::vector<BuildingPoints> buildings;     // by model, then buildings without a model by rising value of the field
  PointOwner owner = PointOwner::automatic;  // the one used
  std::uint64_t read = 0;                    // points of the class asked for
  std::uint64_t unassigned = 0;              // those that belong to no building
  std::uint64_t models_without_points = 0;
  double metres_per_unit = 1;
};

// Reads a cloud; Error when it cannot be read or lacks the field asked for. 32 bytes a point.
ModelPoints read_model_points(const std::filesystem::path& cloud, std::span<const PolygonModel> models,
                              const ModelPointsParams& params = {});

}  // namespace ilot
