// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/compare/evaluation_report.h"
#include "engine/compare/roofs/wireframe_report.h"
#include "engine/compare/streets/street_report.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kForeignLimit = 0.01;  // share of foreign points above which a found plane is counted

Json number(double v) {
  return std::isfinite(v) ? Json(v) : Json();
}

Json number(std::optional<double> v) {
  return v ? number(*v) : Json();
}

Json json_of(const ConfusionMatrix& m) {
  const std::size_t n = m.classes.size();
  Json json{{"classes", m.classes},
            {"matrix", Json::array()},
            {"undetected", Json::array()},
            {"precision", Json::array()},
            {"sensitivity", Json::array()}};
  for (std::size_t c = 0; c < n; ++c) {
    json["matrix"].push_back(std::vector<std::uint64_t>(m.counts[c].begin(), m.counts[c].end() - 1));
    json["undetected"].push_back(m.counts[c].back());
    json["precision"].push_back(number(precision(m, c)));
    json["sensitivity"].push_back(number(sensitivity(m, c)));
  }
  json["global_sensitivity"] = number(global_sensitivity(m));
  return json;
}

Json json_of(const ErrorSummary& e) {
  return {{"mean", number(e.mean)}, {"median", number(e.median)}, {"largest", number(e.largest)}};
}

Json json_of(const PlaneEvaluation& p) {
  const PlaneMatching& m = p.matching;
  Json json{{"true", m.true_planes}, {"found", m.found_planes}, {"matched", m.matches.size()},
            {"over", m.over},        {"under", m.under},        {"missed", m.missed}};
  if (p.sizes)
    for (const PlaneSizeClass& s : *p.sizes)
      json["sizes"].push_back({{"from_m2", s.from_m2}, {"true", s.truth}, {"matched", s.matched}});
  if (!p.errors) return json;
  json["angle_deg"] = number(p.errors->angle_deg.mean);
  json["offset_m"] = number(p.errors->offset_m.mean);
  json["errors"] = {{"planes", p.errors->planes},
                    {"angle_deg", json_of(p.errors->angle_deg)},
                    {"offset_m", json_of(p.errors->offset_m)}};
  return json;
}

Json points_json(const PlaneMatching& m) {
  const ForeignPoints foreign = foreign_points(m);
  return {{"true", m.points},
          {"carrying", m.carrying},
          {"share", m.share()},
          {"foreign_share_max", foreign.worst ? foreign.worst->foreign_share() : 0},
          {"found_above_1_percent", foreign.impure}};
}

Json json_of(const MeanAndSpread& v) {
  return {{"mean_m", v.mean}, {"sd_m", v.sd}};
}

Json json_of(const ControlGroup& g) {
  return {{"name", g.name},
          {"n", g.count},
          {"drawn", g.drawn},
          {"missed", g.missed},
          {"mean_m", g.drawn ? Json(g.dd_m.mean) : Json()},
          {"sd_m", g.drawn ? Json(g.dd_m.sd) : Json()},
          {"dx", json_of(g.dx_m)},
          {"dz", json_of(g.dz_m)},
          {"completed", {{"n", g.completed}, {"mean_m", g.completed_dd_m.mean}, {"sd_m", g.completed_dd_m.sd}}}};
}

Json json_of(const RoofEvaluation& r) {
  const RoofResult& result = r.result;
  Json json{{"buildings", result.true_buildings},
            {"models", r.models},
            {"closed", r.closed},
            {"faces_true", result.true_faces},
            {"faces_found", result.found_faces},
            {"faces_matched", result.matched_faces},
            {"rms_m", number(result.rms_m)},
            {"hausdorff_m", number(result.hausdorff_m)},
            {"covered", result.covered},
            {"outline_p95_m", number(result.outline_p95_m)},
            {"edges", edges_json(r.edges)}};
  json["sizes"] = Json::array();
  for (const RoofSizeClass& size : result.classes)
    json["sizes"].push_back({{"from_m2", size.from_m2},
                             {"true", size.truth},
                             {"matched", size.matched},
                             {"right_neighbours", size.right_neighbours}});
  return json;
}

Json json_of(const DrawnEdges& d) {
  Json json{{"true_m", d.true_m}, {"within", Json::array()}, {"stated", Json::array()}};
  for (std::size_t i = 0; i < kEdgeLimitsM.size(); ++i)
    json["within"].push_back({{"limit_m", kEdgeLimitsM[i]}, {"share", d.share(i)}});
  for (const StatedErrors& s : d.stated)
    json["stated"].push_back({{"status", s.status == DrawnStatus::seen ? "seen" : "completed"},
                              {"edges", s.edges},
                              {"within", s.within},
                              {"median_stated_m", s.edges ? Json(s.median_stated_m) : Json()},
                              {"median_true_m", s.edges ? Json(s.median_true_m) : Json()}});
  return json;
}

Json json_of(const std::vector<ObjectClassCounts>& classes) {
  Json json = Json::object();
  for (const ObjectClassCounts& c : classes)
    json[c.name] = {{"true", c.truth}, {"detected", c.detected}, {"right", c.right}};
  return json;
}

Json json_of(const Reliability& r) {
  Json json{
      {"count", r.count}, {"calibration_error", r.count ? Json(r.calibration_error) : Json()}, {"bins", Json::array()}};
  for (const ReliabilityBin& bin : r.bins)
    json["bins"].push_back({{"count", bin.count},
                            {"mean_probability", bin.count ? Json(bin.mean_probability) : Json()},
                            {"right", bin.count ? Json(bin.right) : Json()}});
  return json;
}

}  // namespace

ForeignPoints foreign_points(const PlaneMatching& m) {
  ForeignPoints result;
  for (const FoundPlane& plane : m.found) {
    if (!result.worst || plane.foreign_share() > result.worst->foreign_share()) result.worst = &plane;
    result.impure += plane.foreign_share() > kForeignLimit;
  }
  return result;
}

std::string evaluation_json(const Evaluation& e) {
  Json json{{"result", e.result}, {"truth", e.truth}};
  if (e.confusion) {
    json["confusion"] = json_of(*e.confusion);
    json["confusion"]["from"] = e.class_source == ClassSource::segments ? "segments"
                                : e.class_source == ClassSource::labels ? "labels"
                                                                        : "facade labels";
  }
  if (e.planes) {
    json["planes"] = json_of(*e.planes);
    json["points"] = points_json(e.planes->matching);
  }
  if (e.boundary)
    json["boundary"] = {{"error", number(e.boundary->error())},
                        {"planes", e.boundary_planes},
                        {"true", e.boundary->truth},
                        {"found", e.boundary->found},
                        {"common", e.boundary->common}};
  if (e.control_points) {
    json["control_points"]["groups"] = Json::array();
    for (const ControlGroup& group : *e.control_points) json["control_points"]["groups"].push_back(json_of(group));
  }
  if (e.openings)
    json["openings"] = {{"true", e.openings->truth},        {"found", e.openings->found},
                        {"matched", e.openings->matched},   {"iou_mean", e.openings->iou_mean},
                        {"invented", e.openings->invented}, {"ring_distance_m", e.openings->ring_distance_m}};
  if (e.facade_sides) json["facades"] = {{"judged", e.facade_sides->judged}, {"mirrored", e.facade_sides->mirrored}};
  if (e.drawn_edges) json["edges"] = json_of(*e.drawn_edges);
  if (e.roofs) json["roofs"] = json_of(*e.roofs);
  if (e.objects)
    json["objects"] = {{"true", e.objects->truth},
                       {"unseen", e.objects->unseen},
                       {"found", e.objects->found},
                       {"detected", e.objects->detected},
                       {"false", e.objects->false_found},
                       {"right_class", number(e.objects->right_class)},
                       {"detected_and_right", number(e.objects->detected_and_right)},
                       {"classes", json_of(e.objects->classes)},
                       {"right_group", number(e.objects->right_group)},
                       {"groups", json_of(e.objects->groups)},
                       {"confusion", json_of(e.objects->confusion)}};
  if (e.probabilities) {
    json["probabilities"] = json_of(e.probabilities->all);
    for (const auto& [name, r] : e.probabilities->by_class) json["probabilities"]["classes"][name] = json_of(r);
  }
  if (e.trees) json["trees"] = trees_json(*e.trees);
  if (e.kerbs) json["kerbs"] = kerbs_json(*e.kerbs);
  if (e.pavements) json["pavements"] = pavements_json(*e.pavements);
  if (e.carriageways) json["carriageways"] = carriageways_json(*e.carriageways);
  json["notes"] = e.notes;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ilot
