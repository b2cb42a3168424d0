// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/wireframe_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/compare/evaluate.h"
#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"
#include "engine/proof/point_stream.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

Wireframe read_wireframe(const std::string& path) {
  const ModelFile file = read_models(path);
  if (file.lines.empty())
    throw Error(path + ": contains no line (l); a wireframe is an OBJ file with corners (v) and edges (l)");
  Wireframe wireframe{path, {}, 0};
  for (const auto& [a, b] : file.lines) wireframe.edges.push_back({a, b});
  return wireframe;
}

FlatBox box_of(const Wireframe& wireframe) {
  FlatBox box = FlatBox::none();
  for (const Edge3& edge : wireframe.edges) {
    box.add({edge.a.x, edge.a.y});
    box.add({edge.b.x, edge.b.y});
  }
  return box;
}

// Replaces the radii of the wireframes that have points; returns which ones and the unit of the clouds.
struct Radii {
  std::vector<bool> from_points;
  double metres_per_unit = 1;
};

Radii measure_radii(const std::vector<fs::path>& clouds, std::vector<Wireframe>& wireframes) {
  Radii radii{std::vector<bool>(wireframes.size()), 1};
  std::vector<std::vector<Vec3>> points(wireframes.size());
  for (const fs::path& cloud : clouds) {
    const std::unique_ptr<PointReader> reader = open_cloud(cloud);
    reader->limit_to(kFieldZ);
    radii.metres_per_unit = reader->info().crs.metres_per_unit;
    std::vector<FlatBox> boxes;
    for (const Wireframe& w : wireframes) boxes.push_back(box_of(w).grown(kAroundWireframe / radii.metres_per_unit));
    for_each_record(*reader, [&](const std::byte* record) {
      const Vec3 p = position_of(record, reader->info().layout);
      for (std::size_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].contains(FlatPoint{p.x, p.y})) points[i].push_back(p);
    });
  }
  for (std::size_t i = 0; i < wireframes.size(); ++i) {
    radii.from_points[i] = !points[i].empty();
    wireframes[i].radius = points[i].empty() ? radius_of(wireframes[i].edges) : radius_of(points[i]);
  }
  return radii;
}

std::string number_text(std::optional<double> value, int digits = 3) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string share_text(std::optional<double> share) {
  return share ? fmt::format("{:.1f} %", 100 * *share) : "-";
}

OrderedJson value_json(std::optional<double> value) {
  return value ? OrderedJson(*value) : OrderedJson();
}

}  // namespace

WireframeEvaluation evaluate_wireframes(const fs::path& result, std::span<const std::string> files) {
  const ResultFiles found = find_results(result);
  if (!found.roofs)
    throw Error(result.string() + ": contains no models of roofs (roofs/*.city.jsonl, *.city.json or *.obj)");
  std::vector<Wireframe> wireframes;
  for (const std::string& file : files) wireframes.push_back(read_wireframe(file));
  const Radii radii = measure_radii(found.clouds, wireframes);
  const std::vector<EdgeScore> scores =
      compare_wireframes(wireframes, read_models(*found.roofs).models, found.outlines_given, radii.metres_per_unit);
  WireframeEvaluation evaluation{result.string(), found.outlines_given, {}, {}};
  for (std::size_t i = 0; i < wireframes.size(); ++i) {
    evaluation.wireframes.push_back(
        {files[i], kEdgeShare * wireframes[i].radius * radii.metres_per_unit, radii.from_points[i], scores[i]});
    evaluation.all.add(scores[i]);
  }
  return evaluation;
}

std::string edges_text(const EdgeScore& s) {
  return fmt::format(
      "edges    true {}  drawn {} ({} times)  matched {}  precision {}  recall {}  F1 {}  F1 within {:g} m {}\n"
      "corners of matched edges off by {} m; edges under {:g} m {} of {} ({})\n",
      s.truth, s.drawn, number_text(s.drawn_over_true(), 2), s.matched, number_text(s.precision()),
      number_text(s.recall()), number_text(s.f1()), kCloseEdge, number_text(s.f1_close()),
      number_text(s.corner_offset_m()), kShortEdge, s.short_edges, s.judged_length, share_text(s.short_share()));
}

OrderedJson edges_json(const EdgeScore& s) {
  return {{"true", s.truth},
          {"drawn", s.drawn},
          {"matched", s.matched},
          {"precision", value_json(s.precision())},
          {"recall", value_json(s.recall())},
          {"f1", value_json(s.f1())},
          {"matched_close", s.close},
          {"f1_close", value_json(s.f1_close())},
          {"corner_offset_m", value_json(s.corner_offset_m())},
          {"drawn_over_true", value_json(s.drawn_over_true())},
          {"judged_length", s.judged_length},
          {"short", s.short_edges},
          {"short_share", value_json(s.short_share())}};
}

std::string wireframes_text(const WireframeEvaluation& evaluation) {
  std::string text;
  for (const WireframeScore& w : evaluation.wireframes)
    text += fmt::format("{}\ntolerance {:.3f} m, a tenth of the radius of {}\n{}\n", w.file, w.tolerance_m,
                        w.from_points ? "the building's points" : "the wireframe's corners", edges_text(w.score));
  return evaluation.wireframes.size() == 1 ? text : text + "all\n" + edges_text(evaluation.all);
}

std::string wireframes_json(const WireframeEvaluation& evaluation) {
  OrderedJson json{{"result", evaluation.result},
                   {"outlines_given", evaluation.outlines_given},
                   {"wireframes", OrderedJson::array()},
                   {"all", edges_json(evaluation.all)}};
  for (const WireframeScore& w : evaluation.wireframes) {
    OrderedJson row{{"file", w.file}, {"tolerance_m", w.tolerance_m}, {"radius_from_points", w.from_points}};
    row.update(edges_json(w.score));
    json["wireframes"].push_back(std::move(row));
  }
  return json.dump(2) + "\n";
}

}  // namespace ilot
