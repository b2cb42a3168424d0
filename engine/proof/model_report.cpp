// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/model_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(PointOwner owner) {
  constexpr const char* names[] = {"automatic", "field", "plan", "everything"};
  return names[static_cast<std::size_t>(owner)];
}

std::string metres(double v) {
  return std::isfinite(v) ? fmt::format("{:.3f}", v) : "missing";
}

Json model_number(double v) {
  return std::isfinite(v) ? Json(v) : Json();
}

std::string row(const char* name, double over_points, const Percentiles& p) {
  return fmt::format("{:<24}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", name, metres(over_points), metres(p.p10),
                     metres(p.median), metres(p.p90), metres(p.p95), metres(p.largest));
}

Json json_of(const Percentiles& p) {
  return {{"p10", model_number(p.p10)},
          {"median", model_number(p.median)},
          {"p90", model_number(p.p90)},
          {"p95", model_number(p.p95)},
          {"largest", model_number(p.largest)}};
}

}  // namespace

std::string model_text(const ModelEvaluation& e) {
  const ModelResiduals& r = e.residuals;
  std::string text = fmt::format("buildings  {} judged, {} of them missing; {} models without points\n",
                                 r.buildings.size(), r.missing, e.points.models_without_points);
  text += fmt::format("points     {} read, {} judged, {} of no building; buildings by {}; distance to {}\n\n",
                      e.points.read, r.points, e.points.unassigned, name_of(e.points.owner),
                      e.params.faces == EvaluatedFaces::roofs ? "roofs" : "all faces");
  text += fmt::format("{:<24}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "", "points", "p10", "median", "p90", "p95", "largest");
  text += row("RMSE, m", r.rmse_m, r.building_rmse_m);
  text += row(fmt::format("RMSE of nearest {:.0f} %, m", 100 * e.params.kept_share).c_str(), r.trimmed_rmse_m,
              r.building_trimmed_rmse_m);
  text += row(fmt::format("share within {} m", e.params.near_m).c_str(), r.near_share, r.building_near_share);
  return text;
}

std::string model_json(const ModelEvaluation& e) {
  const ModelResiduals& r = e.residuals;
  Json json{{"models", e.models},
            {"cloud", e.cloud},
            {"points_of", name_of(e.points.owner)},
            {"faces", e.params.faces == EvaluatedFaces::roofs ? "roofs" : "all"}};
  json["points"] = {{"read", e.points.read}, {"judged", r.points}, {"unassigned", e.points.unassigned}};
  json["buildings"] = {
      {"judged", r.buildings.size()}, {"missing", r.missing}, {"without_points", e.points.models_without_points}};
  json["over_points"] = {{"rmse_m", r.rmse_m}, {"trimmed_rmse_m", r.trimmed_rmse_m}, {"near_share", r.near_share}};
  json["over_buildings"] = {{"rmse_m", json_of(r.building_rmse_m)},
                            {"trimmed_rmse_m", json_of(r.building_trimmed_rmse_m)},
                            {"near_share", json_of(r.building_near_share)}};
  json["list"] = Json::array();
  for (const BuildingResidual& b : r.buildings)
    json["list"].push_back({{"name", b.name},
                            {"points", b.points},
                            {"faces", b.faces},
                            {"rmse_m", model_number(b.rmse_m)},
                            {"trimmed_rmse_m", model_number(b.trimmed_rmse_m)},
                            {"near_share", b.near_share},
                            {"largest_m", model_number(b.largest_m)}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ilot
