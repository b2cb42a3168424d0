// SPDX-License-Identifier: Apache-2.0
#include "engine/report/run_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/report/path_text.h"
#include "engine/settings/config.h"
#include "engine/version.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

Json inputs_json(const RunRecord& record) {
  Json list = Json::array();
  for (const InputRecord& input : record.inputs) {
    list.push_back({{"path", path_text(input.path)},
                    {"format", input.format},
                    {"crs", input.crs},
                    {"points", input.points},
                    {"bytes", input.bytes}});
    if (!input.dialect.empty()) list.back()["dialect"] = input.dialect;
    if (!input.output.empty()) list.back()["output"] = path_text(input.output);
  }
  return list;
}

Json stages_json(const RunRecord& record) {
  Json list = Json::array();
  for (const StageRecord& stage : record.stages) {
    const double rate = stage.seconds > 0 ? static_cast<double>(stage.points) / stage.seconds : 0;
    list.push_back({{"name", stage.name},
                    {"seconds", stage.seconds},
                    {"cpu_seconds", stage.cpu_seconds},
                    {"points", stage.points},
                    {"points_per_second", rate}});
  }
  return list;
}

Json counts_json(const RunRecord& record) {
  Json counts;
  counts["points"] = {{"read", record.points.read},
                      {"labelled", record.points.labelled},
                      {"unlabelled", record.points.unlabelled},
                      {"rejected", record.points.rejected_total()}};
  if (record.planes) counts["planes"] = *record.planes;
  if (record.shapes) counts["shapes"] = *record.shapes;
  if (record.roofs)
    counts["roofs"] = {{"buildings", record.roofs->buildings}, {"lod22", record.roofs->lod22},
                       {"lod12", record.roofs->lod12},         {"footprint_only", record.roofs->footprint_only},
                       {"valid", record.roofs->valid},         {"invalid", record.roofs->invalid},
                       {"thinned", record.roofs->thinned}};
  if (record.facades)
    counts["facades"] = {{"facades", record.facades->facades},
                         {"elements", record.facades->elements},
                         {"occluded_edges", record.facades->occluded_edges}};
  if (record.streets)
    counts["streets"] = {{"objects", record.streets->objects},     {"blocks", record.streets->blocks},
                         {"gaps", record.streets->gaps},           {"trees", record.streets->trees},
                         {"kerbs", record.streets->kerbs},         {"pavement_widths", record.streets->pavement_widths},
                         {"pavements", record.streets->pavements}, {"carriageways", record.streets->carriageways}};
  return counts;
}

Json overlaps_json(const std::vector<OverlapRecord>& overlaps) {
  Json list = Json::array();
  for (const OverlapRecord& o : overlaps) list.push_back({{"id", o.id}, {"with", o.with}});
  return list;
}

Json footprints_json(const FootprintsRecord& f) {
  return {{"path", f.path},
          {"footprints", f.footprints},
          {"id_attribute", f.id_attribute},
          {"transformed", f.transformed},
          {"mended", f.mended},
          {"without_outline", f.without_outline},
          {"overlapping", f.overlaps.size()},
          {"overlaps", overlaps_json(f.overlaps)},
          {"outside", f.outside},
          {"shift_m", {f.shift_x_m, f.shift_y_m}},
          {"points_inside", f.inside},
          {"points_inside_shifted", f.inside_shifted}};
}

Json edits_json(const EditsRecord& e) {
  return {{"given", e.given},       {"made", e.made},
          {"repeated", e.repeated}, {"without_partner", e.without_partner},
          {"outside", e.outside},   {"not_asked", e.not_asked}};
}

Json skipped_json(const RunRecord& record) {
  Json list = Json::array();
  for (const SkippedRecord& s : record.skipped) {
    list.push_back({{"what", s.what}, {"where", s.where}, {"reason", s.reason}});
  }
  return list;
}

Json results_json(const RunRecord& record) {
  Json list = Json::array();
  for (const ResultRecord& file : record.results)
    list.push_back({{"path", path_text(file.path)}, {"bytes", file.bytes}});
  return list;
}

Json training_json(const RunRecord& record) {
  Json list = Json::array();
  for (const TrainedClass& c : record.training)
    list.push_back(
        {{"class", c.name}, {"label", c.label}, {"samples", c.samples}, {"judged", c.judged}, {"right", c.right}});
  return list;
}

Json chosen_json(const RunRecord& record) {
  Json list = Json::array();
  for (const ChosenRecord& c : record.chosen) {
    const Json value = std::visit([](const auto& v) { return Json(v); }, c.value);
    list.push_back({{"key", c.key}, {"value", value}, {"why", c.why}});
  }
  return list;
}

}  // namespace

std::uint64_t PointCounts::rejected_total() const {
  std::uint64_t total = 0;
  for (const auto& [reason, points] : rejected) total += points;
  return total;
}

std::string run_json(const RunRecord& record) {
  Json json;
  json["version"] = version();
  json["git_hash"] = git_hash();
  json["exit_code"] = static_cast<int>(record.exit);
  json["products"] = record.products;
  json["parameters"] = Json::parse(settings_json(record.settings));
  json["parameters_hash"] = fmt::format("{:016x}", settings_hash(record.settings));
  json["chosen"] = chosen_json(record);
  if (!record.training.empty()) json["training"] = training_json(record);
  json["threads"] = record.threads;
  json["memory_bytes"] = record.memory_bytes;
  json["inputs"] = inputs_json(record);
  json["crs"] = {{"name", record.crs.name}, {"metres_per_unit", record.crs.metres_per_unit}};
  if (!record.crs.wkt.empty()) json["crs"]["wkt"] = record.crs.wkt;
  json["unit_assumed"] = record.unit_assumed;
  json["stages"] = stages_json(record);
  json["seconds"] = record.seconds;
  json["peak_rss_bytes"] = record.peak_rss_bytes;
  json["blocks"] = record.blocks;
  json["counts"] = counts_json(record);
  if (record.footprints) json["footprints"] = footprints_json(*record.footprints);
  if (record.clusters)
    json["clusters"] = {{"clusters", record.clusters->clusters},
                        {"too_small", record.clusters->too_small},
                        {"points_of_too_small", record.clusters->points_of_too_small},
                        {"without_model", record.clusters->without_model}};
  if (record.edits) json["edits"] = edits_json(*record.edits);
  if (record.cells)
    json["cells"] = {
        {"unit", record.cells->unit}, {"edge_steps", record.cells->edge}, {"most_points", record.cells->most_points}};
  json["rejected"] = record.points.rejected;
  json["skipped"] = skipped_json(record);
  json["warnings"] = record.warnings;
  if (!record.request.empty()) json["request"] = Json::parse(record.request);
  json["results"] = results_json(record);
  json["result_hash"] = record.result_hash;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_run_json(const RunRecord& record, const std::filesystem::path& out) {
  write_whole_file(out / "run.json", run_json(record));
}

}  // namespace ilot
