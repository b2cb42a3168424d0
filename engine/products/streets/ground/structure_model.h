// SPDX-License-Identifier: Apache-2.0
// Boosted trees that tell what stands in a cell, as they were learnt from scanned streets.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/products/streets/ground/standing_features.h"
#include "kernels/classifiers/boosted_trees.h"

namespace ilot {

// What stands in a tall cell.
enum class StandingKind : std::uint8_t { facade, roof, crown, object };
constexpr std::size_t kStandingKinds = 4;
// Choice: higher than what pavements carry in rows (planters, bins, benches), and low enough for clouds that are cut at
// little more than a metre.
constexpr double kLeastDecided = 1;  // metres above the terrain; cells that are lower are not decided

struct StructureModel {
  std::string recipe;  // how it was made; lines
  BoostedTrees trees;  // a column is a feature of standing_features.h
};

// The kind with the greatest share for each row (ties: the first).
std::vector<StandingKind> standing_kinds(const StructureModel& model, const StandingRows& rows);

// A text with all digits, and the model of such a text. Throws Error(usage) with `name` where it is none.
std::string structure_model_text(const StructureModel& model);
StructureModel parse_structure_model(std::string_view text, const std::string& name);

// The model of the library, for clouds from the ground.
const StructureModel& default_structure_model();

}  // namespace ilot
