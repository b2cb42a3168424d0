// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/evaluate.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/compare/labels/label_counts.h"
#include "engine/deliverables/layers/gpkg_readers.h"
#include "engine/deliverables/solids/model_file.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/planes_csv.h"
#include "engine/error.h"
#include "engine/model/point_label.h"
#include "engine/proof/point_stream.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder, const std::function<bool(const fs::path&)>& wanted) {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
    if (entry.is_regular_file() && wanted(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

LabelCounts count_all(const ResultFiles& files, const Truth& truth, const EvaluateParams& params) {
  std::unordered_set<std::uint32_t> objects;
  for (const TrueObject& object : truth.objects) objects.insert(object.id);
  LabelCounts counts;
  const bool in_words = !files.facades.empty() && !truth.elements.empty();
  const FacadeTruthLabels words = in_words ? facade_truth_labels(truth) : FacadeTruthLabels{};
  for (const fs::path& cloud : files.clouds)
    count_labels(cloud, params.found_field, objects, in_words ? &words : nullptr, counts);
  return counts;
}

// The names of true_class. Where the truth has no list of them, they come from the planes.
ClassNames class_names(const LabelCounts& counts, const Truth& truth) {
  ClassNames names = truth.classes;
  for (const TruePlane& plane : truth.planes) {
    const auto kind = counts.class_of.find(plane.id);
    if (kind != counts.class_of.end() && !plane.class_name.empty()) names.emplace(kind->second, plane.class_name);
  }
  return names;
}

// The names of the labels of points. A class of street objects that the truth does not have counts as its group: the
// points of a truth have four classes of objects.
ClassNames found_class_names(const ClassNames& truth) {
  ClassNames names = point_label_names();
  for (auto& [value, name] : names) {
    const auto same = [&](const auto& entry) { return entry.second == name; };
    if (std::none_of(truth.begin(), truth.end(), same)) name = label_name(group_of(static_cast<PointLabel>(value)));
  }
  return names;
}

void evaluate_classes(const LabelCounts& counts, const Truth& truth, Evaluation& evaluation) {
  if (!counts.has_true_class) return;
  const ClassNames names = class_names(counts, truth);
  // The truth of a facade knows no class of street objects.
  if (counts.any_label && !counts.facade_labels.sorted().empty()) {
    evaluation.class_source = ClassSource::facade_labels;
    evaluation.confusion =
        confusion_of_labels(counts.facade_labels.sorted(), point_label_names(), found_class_names({}));
  } else if (counts.any_label) {
    evaluation.class_source = ClassSource::labels;
    evaluation.confusion = confusion_of_labels(counts.class_labels.sorted(), names, found_class_names(names));
  } else if (counts.has_planes) {
    evaluation.confusion = confusion_of_segments(counts.class_segments.sorted(), names);
  }
}

void evaluate_planes(const ResultFiles& files, const LabelCounts& counts, const Truth& truth,
                     const EvaluateParams& params, Evaluation& evaluation) {
  if (!counts.has_true_plane || !counts.has_planes) return;
  std::function<bool(std::uint32_t)> judged;
  if (params.only_class || params.min_points > 1)
    judged = [&](std::uint32_t plane) {
      const auto kind = static_cast<int>(counts.class_of.at(plane));
      return (!params.only_class || kind == *params.only_class) &&
             counts.points_of_plane.at(plane) >= params.min_points;
    };
  PlaneEvaluation planes{match_planes(counts.planes.sorted(), judged, params.rule), {}, {}};
  if (files.planes_csv && !truth.planes.empty())
    planes.errors =
        plane_errors(planes.matching.matches, truth.planes, read_planes_csv(*files.planes_csv), counts.metres_per_unit);
  const auto has_polygons = [](const TruePlane& plane) { return !plane.polygons.empty(); };
  if (std::any_of(truth.planes.begin(), truth.planes.end(), has_polygons)) {
    const auto seen_and_judged = [&](std::uint32_t plane) {
      return counts.points_of_plane.count(plane) != 0 && (!judged || judged(plane));
    };
    planes.sizes = plane_sizes(planes.matching.matches, truth.planes, seen_and_judged, counts.metres_per_unit);
  }
  evaluation.planes = std::move(planes);
}

// Collects the points of the true planes that are matched and have polygons, and of their partners.
class BoundaryCollector {
 public:
  BoundaryCollector(const std::vector<PlaneMatch>& matches, const Truth& truth) {
    std::map<std::uint32_t, const TruePlane*> with_polygons;
    for (const TruePlane& plane : truth.planes)
      if (!plane.polygons.empty()) with_polygons.emplace(plane.id, &plane);
    for (const PlaneMatch& match : matches) {
      const auto plane = with_polygons.find(match.truth);
      if (plane == with_polygons.end()) continue;
      by_truth_[match.truth] = by_found_[match.found] = planes_.size();
      planes_.push_back(plane->second);
    }
    points_.resize(planes_.size());
  }

  void add_cloud(const fs::path& cloud, const std::string& found_field) {
    const std::unique_ptr<PointReader> reader = open_cloud(cloud);
    const RecordLayout& layout = reader->info().layout;
    const ExtraField truth = require_field(reader->info(), "true_plane", FieldType::u32);
    const ExtraField found = require_field(reader->info(), found_field, FieldType::u32);
    const auto boundary = find_integer_field(layout, "boundary");
    for_each_record(*reader, [&](const std::byte* record) {
      const auto t = by_truth_.find(load<std::uint32_t>(record + truth.offset));
      const auto f = by_found_.find(load<std::uint32_t>(record + found.offset));
      const bool marked = boundary && integer_of(record, *boundary) != 0 && f != by_found_.end();
      if (t != by_truth_.end()) add(t->second, position_of(record, layout), 1, marked && f->second == t->second);
      if (marked && (t == by_truth_.end() || f->second != t->second)) add(f->second, position_of(record, layout), 0, 1);
    });
  }

  std::size_t planes() const { return planes_.size(); }

  BoundaryCounts sum(double metres_per_unit) const {
    std::vector<BoundaryCounts> parts(planes_.size());
    parallel_for(planes_.size(),
                 [&](std::size_t i) { parts[i] = boundary_counts(*planes_[i], points_[i], metres_per_unit); });
    BoundaryCounts all;
    for (const BoundaryCounts& part : parts) all.add(part);
    return all;
  }

 private:
  void add(std::size_t plane, Vec3 p, std::uint8_t true_point, std::uint8_t marked) {
    points_[plane].own.push_back(p);
    points_[plane].true_point.push_back(true_point);
    points_[plane].marked.push_back(marked);
  }

  std::unordered_map<std::uint32_t, std::size_t> by_truth_, by_found_;
  std::vector<const TruePlane*> planes_;
  std::vector<BoundaryPoints> points_;
};

void evaluate_boundary(const ResultFiles& files, const LabelCounts& counts, const Truth& truth,
                       const EvaluateParams& params, Evaluation& evaluation) {
  if (!evaluation.planes || !counts.has_boundary) return;
  BoundaryCollector collector(evaluation.planes->matching.matches, truth);
  if (collector.planes() == 0) return;
  for (const fs::path& cloud : files.clouds) collector.add_cloud(cloud, params.found_field);
  evaluation.boundary_planes = collector.planes();
  evaluation.boundary = collector.sum(counts.metres_per_unit);
}

void evaluate_facades(const ResultFiles& files, const Truth& truth, const EvaluateParams& params,
                      double metres_per_unit, Evaluation& evaluation) {
  if (!truth.has_openings && !truth.has_control_points) return;
  std::vector<Facade> facades;
  for (const fs::path& file : files.facades) facades.push_back(read_facade_json(file));
  if (facades.empty()) {
    evaluation.notes.emplace_back("no facades/*.json: openings and control points are not judged");
    return;
  }
  if (truth.has_control_points)
    evaluation.control_points = evaluate_control_points(
        truth.control_points, facades, {params.control_point_limit_m, 0.5, metres_per_unit, params.as_documents});
  if (!truth.has_openings) return;
  const OpeningMatching rule{0.5, 0.5, metres_per_unit};
  evaluation.openings = evaluate_openings(truth.openings, facades, rule);
  evaluation.facade_sides = evaluate_facade_sides(truth.openings, facades, metres_per_unit);
  evaluation.drawn_edges =
      evaluate_drawn_edges(truth.openings, match_openings(truth.openings, facades, rule), metres_per_unit);
}

void evaluate_roof_models(const ResultFiles& files, const Truth& truth, double metres_per_unit,
                          Evaluation& evaluation) {
  if (!truth.has_buildings) return;
  if (!files.roofs) {
    evaluation.notes.emplace_back("no roofs/*.city.jsonl, *.city.json or *.obj: roofs are not judged");
    return;
  }
  const auto first = std::find_if(truth.planes.begin(), truth.planes.end(),
                                  [](const TruePlane& plane) { return !plane.polygons.empty(); });
  if (first == truth.planes.end()) return;
  const Vec3 origin = first->polygons[0].ring[0];
  const ModelFile file = read_models(*files.roofs);
  RoofParams params;
  params.metres_per_unit = metres_per_unit;
  RoofEvaluation roofs{
      evaluate_roofs(true_roofs(truth.planes, origin), model_roofs(file.models, origin, metres_per_unit), params),
      file.models.size(),
      0,
      {}};
  for (const PolygonModel& model : file.models) roofs.closed += is_closed(model);
  const std::vector<Wireframe> wireframes = true_wireframes(truth.planes, metres_per_unit);
  for (const EdgeScore& score : compare_wireframes(wireframes, file.models, files.outlines_given, metres_per_unit))
    roofs.edges.add(score);
  evaluation.roofs = roofs;
}

// Found objects without a partner in the truth have the wrong class, whatever it is.
ProbabilityEvaluation evaluate_probabilities(const fs::path& file, const std::map<std::uint32_t, bool>& right) {
  std::vector<JudgedProbability> all;
  std::map<std::string, std::vector<JudgedProbability>> by_class;
  for (const StreetObject& object : read_objects_gpkg(file)) {
    if (object.by_hand) continue;  // states no probability
    const auto known = right.find(object.id);
    all.push_back({object.probability, known != right.end() && known->second});
    by_class[object.class_name].push_back(all.back());
  }
  ProbabilityEvaluation result{reliability(all), {}};
  for (const auto& [name, statements] : by_class) result.by_class[name] = reliability(statements);
  return result;
}

void evaluate_street(const ResultFiles& files, const LabelCounts& counts, const Truth& truth, Evaluation& evaluation) {
  if (!truth.has_objects || !counts.has_true_element) return;
  if (!counts.has_objects) {
    evaluation.notes.emplace_back("no extra bytes 'object_id': objects are not judged");
    return;
  }
  evaluation.objects =
      evaluate_objects(truth.objects, counts.objects.sorted(), counts.object_labels.sorted(), point_label_names());
  if (files.objects)
    evaluation.probabilities = evaluate_probabilities(*files.objects, evaluation.objects->right_of_found);
}

// Trees and kerbs of a street, with what the cloud has of those of the truth.
void evaluate_street_map(const ResultFiles& files, const LabelCounts& counts, const Truth& truth,
                         Evaluation& evaluation) {
  if ((!truth.has_trees && !truth.has_kerbs) || !counts.has_true_element || !files.trees || !files.kerbs) return;
  std::map<std::uint32_t, SeenTree> trees;
  for (const TrueTree& tree : truth.trees) trees[tree.id] = {};
  const double metres = counts.metres_per_unit;
  KerbSight sight(truth.kerbs, metres);
  std::uint32_t ground = 0;
  for (const auto& [number, name] : truth.classes)
    if (name == "ground") ground = number;
  for (const fs::path& cloud : files.clouds) {
    const std::unique_ptr<PointReader> reader = open_cloud(cloud);
    const RecordLayout& layout = reader->info().layout;
    const auto element = find_integer_field(layout, "true_element"), kind = find_integer_field(layout, "true_class");
    if (!element || !kind) continue;
    for_each_record(*reader, [&](const std::byte* record) {
      const Vec3 p = position_of(record, layout);
      if (static_cast<std::uint32_t>(integer_of(record, *kind)) == ground) sight.add(p);
      const auto tree = trees.find(static_cast<std::uint32_t>(integer_of(record, *element)));
      if (tree == trees.end()) return;
      SeenTree& seen = tree->second;
      seen.top = seen.points == 0 ? p.z : std::max(seen.top, p.z);
      ++seen.points;
    });
  }
  if (truth.has_trees) evaluation.trees = evaluate_trees(truth.trees, trees, read_trees_gpkg(*files.trees), metres);
  if (truth.has_kerbs) evaluation.kerbs = evaluate_kerbs(sight, truth.kerbs, read_kerbs_gpkg(*files.kerbs), metres);
  if (truth.has_pavements && files.pavements)
    evaluation.pavements = evaluate_pavements(sight, truth, read_pavement_widths(*files.pavements), metres);
  if (truth.has_carriageways && files.pavements)
    evaluation.carriageways =
        evaluate_carriageways(sight, truth.carriageways, read_carriageways(*files.pavements), metres);
}

// Tells whether the record of a run states footprints. False without a record.
bool states_footprints(const fs::path& record) {
  std::ifstream file(record);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  return json.is_object() && json.contains("footprints");
}

}  // namespace

ResultFiles find_results(const fs::path& result) {
  ResultFiles files;
  if (!fs::exists(result)) throw Error(result.string() + ": no such file or folder", ExitCode::usage);
  if (!fs::is_directory(result)) {
    if (is_model_file(result))
      files.roofs = result;
    else
      files.clouds.push_back(result);
    return files;
  }
  const auto named = [](const char* end) {
    return [end](const fs::path& path) { return path.filename().string().ends_with(end); };
  };
  files.clouds = files_in(result / "points", is_cloud_extension);
  files.facades = files_in(result / "facades", named(".json"));
  files.outlines_given = states_footprints(result / "run.json");
  if (fs::is_regular_file(result / "planes.csv")) files.planes_csv = result / "planes.csv";
  const auto of_streets = [&](const char* name) {
    const fs::path file = result / "streets" / name;
    return fs::is_regular_file(file) ? std::optional(file) : std::nullopt;
  };
  files.objects = of_streets("objects.gpkg");
  files.trees = of_streets("trees.gpkg"), files.kerbs = of_streets("kerbs.gpkg");
  files.pavements = of_streets("pavements.gpkg");
  for (const char* end : {".city.jsonl", ".city.json", ".obj"}) {
    const std::vector<fs::path> models = files_in(result / "roofs", named(end));
    if (!files.roofs && !models.empty()) files.roofs = models.front();
  }
  if (files.clouds.empty() && files.facades.empty() && !files.roofs)
    throw Error(result.string() + ": contains neither points/ nor facades/ nor roofs/; give the output folder of a run",
                ExitCode::usage);
  return files;
}

Evaluation evaluate(const fs::path& result, const Truth& truth, const EvaluateParams& params) {
  const ResultFiles files = find_results(result);
  Evaluation evaluation;
  evaluation.result = result.string();
  const LabelCounts counts = count_all(files, truth, params);
  evaluation.points = counts.points;
  evaluate_classes(counts, truth, evaluation);
  evaluate_planes(files, counts, truth, params, evaluation);
  evaluate_boundary(files, counts, truth, params, evaluation);
  evaluate_facades(files, truth, params, counts.metres_per_unit, evaluation);
  evaluate_roof_models(files, truth, counts.metres_per_unit, evaluation);
  evaluate_street(files, counts, truth, evaluation);
  evaluate_street_map(files, counts, truth, evaluation);
  const bool any_result = evaluation.confusion || evaluation.planes || evaluation.control_points ||
                          evaluation.openings || evaluation.roofs || evaluation.objects || evaluation.trees ||
                          evaluation.kerbs;
  if (!any_result)
    throw Error(result.string() + ": nothing to judge: no extra bytes true_plane or true_class beside '" +
                params.found_field + "', no models that the truth knows; run ilot on the scanned cloud itself");
  return evaluation;
}

}  // namespace ilot
