// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/roof_sink.h"

#include <nlohmann/json.hpp>

namespace ilot {
namespace {

// What the buildings were made from, as an object of JSON. Names of files are in run.json: the models do not depend on
// how the points lie in files.
RoofFilesParams with_sources(RoofFilesParams params, const RunRecord& record) {
  nlohmann::ordered_json sources = nlohmann::ordered_json::object();
  if (record.footprints) sources["footprints"] = record.footprints->footprints;
  if (record.clusters) sources["clusters"] = record.clusters->clusters;
  sources["files"] = "run.json";
  params.city_json.sources = sources.dump();
  return params;
}

}  // namespace

RoofSink::RoofSink(const std::filesystem::path& folder, const RoofFilesParams& params, const Crs& crs,
                   RoofLabels* labels, RunRecord& record)
    : files_(folder, with_sources(params, record), crs), labels_(labels), record_(record) {
  record.roofs.emplace();
}

void RoofSink::take(SiteResult& result) {
  ++units_;
  for (Building& level : result.levels)
    for (BuildingSurface& s : level.surfaces) s.plane_id += s.plane_id > 0 ? planes_ : 0;
  result.levels[0].attributes.emplace_back("unit_id", std::int64_t{units_});
  files_.add(result.levels);
  if (labels_ != nullptr) labels_->add(units_, planes_ + 1, result.labels);
  planes_ += result.planes;
  count(result);
}

void RoofSink::finish() {
  files_.finish();
}

void RoofSink::count(const SiteResult& result) {
  RoofCounts& counts = *record_.roofs;
  ++counts.buildings;
  counts.thinned += result.thinned;
  counts.lod22 += result.status == RoofStatus::lod22;
  counts.lod12 += result.status == RoofStatus::lod12;
  counts.valid += result.status != RoofStatus::footprint_only;  // others are not delivered
  if (result.status != RoofStatus::footprint_only) return;
  ++counts.footprint_only;
  if (record_.clusters)
    ++record_.clusters->without_model[result.reason];
  else
    record_.skipped.push_back({"unit", result.levels[0].id, result.reason});
}

}  // namespace ilot
