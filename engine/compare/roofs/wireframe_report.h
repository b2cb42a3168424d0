// SPDX-License-Identifier: Apache-2.0
// `ilot evaluate OUT --wireframe FILE...`: the edges of drawn roofs against true wireframes in files.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/roofs/wireframe.h"

namespace ilot {

struct WireframeScore {
  std::string file;
  double tolerance_m = 0;
  bool from_points = false;  // the radius is that of the building's points, not of the wireframe's corners
  EdgeScore score;
};

struct WireframeEvaluation {
  std::string result;
  bool outlines_given = false;
  std::vector<WireframeScore> wireframes;
  EdgeScore all;
};

// Judges the models of `result` (the output folder of a run, or a file of models) by wireframes: OBJ files of v and l
// lines, one building each, in the coordinates of the models. The radius of a building is that of the points of the
// result within `kAroundWireframe` of the wireframe's box in plan; where there are none it is that of the wireframe's
// corners. Memory: 24 bytes for each of these points. Throws Error when a file has no lines or there are no models.
constexpr double kAroundWireframe = 1;  // metres
WireframeEvaluation evaluate_wireframes(const std::filesystem::path& result, std::span<const std::string> files);

std::string wireframes_text(const WireframeEvaluation& evaluation);
std::string wireframes_json(const WireframeEvaluation& evaluation);

// The figures of a score, as every report shows them.
std::string edges_text(const EdgeScore& score);
nlohmann::ordered_json edges_json(const EdgeScore& score);

}  // namespace ilot
