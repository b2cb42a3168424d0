// SPDX-License-Identifier: Apache-2.0
// Compares a result with the truth, in everything that both of them contain.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/compare/facades/control_points.h"
#include "engine/compare/facades/drawn_edges.h"
#include "engine/compare/facades/facade_sides.h"
#include "engine/compare/facades/openings.h"
#include "engine/compare/labels/confusion.h"
#include "engine/compare/labels/objects.h"
#include "engine/compare/labels/reliability.h"
#include "engine/compare/planes/boundary_error.h"
#include "engine/compare/planes/plane_errors.h"
#include "engine/compare/planes/plane_sizes.h"
#include "engine/compare/roofs/roofs.h"
#include "engine/compare/roofs/wireframe.h"
#include "engine/compare/streets/carriageway_areas.h"
#include "engine/compare/streets/kerb_errors.h"
#include "engine/compare/streets/pavement_errors.h"
#include "engine/compare/streets/tree_errors.h"

namespace ilot {

struct EvaluateParams {
  std::string found_field = "plane_id";  // u32 extra bytes with the found planes
  std::optional<int> only_class;         // judge only planes of this true_class
  std::uint64_t min_points = 1;          // smaller true planes are not judged
  MatchRule rule = MatchRule::main;
  double control_point_limit_m = 0.3;
  bool as_documents = false;  // definitions of the documents' tables (ControlPointParams)
};

// The source of the classes in the confusion matrix.
enum class ClassSource : std::uint8_t { labels, facade_labels, segments };

struct PlaneEvaluation {
  PlaneMatching matching;
  std::optional<PlaneErrors> errors;  // where planes.csv and true equations exist
  std::optional<PlaneSizes> sizes;    // present where the truth has polygons
};

struct RoofEvaluation {
  RoofResult result;
  std::uint64_t models = 0, closed = 0;  // found buildings, and those of them whose shells are closed
  EdgeScore edges;
};

// The probabilities that objects.gpkg states, of all found objects and by the class that was found.
struct ProbabilityEvaluation {
  Reliability all;
  std::map<std::string, Reliability> by_class;
};

struct Evaluation {
  std::string result, truth;  // as the user named them
  std::uint64_t points = 0;   // of the labelled clouds
  std::optional<ConfusionMatrix> confusion;
  ClassSource class_source = ClassSource::segments;
  std::optional<PlaneEvaluation> planes;
  std::optional<BoundaryCounts> boundary;
  std::uint64_t boundary_planes = 0;  // number of planes over which it is summed
  std::optional<std::vector<ControlGroup>> control_points;
  std::optional<OpeningResult> openings;
  std::optional<DrawnEdges> drawn_edges;  // of openings
  std::optional<FacadeSides> facade_sides;
  std::optional<RoofEvaluation> roofs;
  std::optional<ObjectResult> objects;
  std::optional<ProbabilityEvaluation> probabilities;  // of the classes of found objects
  std::optional<TreeResult> trees;
  std::optional<KerbResult> kerbs;
  std::optional<PavementResult> pavements;
  std::optional<CarriagewayResult> carriageways;
  std::vector<std::string> notes;  // what the truth contains and the result does not
};

// The files in an output folder of a run, or the one file that is given: a labelled cloud, or models of roofs.
struct ResultFiles {
  std::vector<std::filesystem::path> clouds, facades;
  std::optional<std::filesystem::path> planes_csv, roofs, objects, trees, kerbs, pavements;
  bool outlines_given = false;  // the outlines of roofs are footprints
};
ResultFiles find_results(const std::filesystem::path& result);

// Judges `result` by the truth; it is an output folder, a labelled cloud or a file of models. Points carry their truth
// in the extra bytes true_class, true_plane and true_element, so no point is matched by position. Two passes over the
// clouds. Memory grows with the number of labels and, where boundaries are judged, by 32 bytes per point. Throws Error
// when there is nothing to judge.
Evaluation evaluate(const std::filesystem::path& result, const Truth& truth, const EvaluateParams& params = {});

}  // namespace ilot
