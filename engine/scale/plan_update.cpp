// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_update.h"

#include <unordered_map>

#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/parts/part_place.h"
#include "engine/scale/records.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// A part that is damaged inside is found by its task or by the merge, which read it to its end.
bool has_part(const fs::path& part, const std::string& key) {
  if (!part_exists(part)) return false;  // throws where a store does not say so: its parts would all be made again
  try {
    return RecordFileReader(part, 1u << 12).head() == part_head(key);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

void take_options(const Plan& old, PlanOptions& options) {
  RunOptions& run = options.run;
  run.products = old.products;
  run.settings = old.settings;
  run.crs = old.crs_option;
  run.dialect = old.dialect;
  if (run.stations.empty()) run.stations = old.stations_file;
  options.area_size = old.area_size;
  options.labels = old.labels;
  if (run.inputs.empty())
    for (const PlanInput& input : old.inputs) run.inputs.emplace_back(input.record.path);
  if (run.footprints.empty() && old.roofs.footprints) {
    run.footprints = old.roofs.footprints->path;
    run.id_field = old.roofs.footprints->id_attribute;
  }
}

std::vector<ChosenRecord> keep_statistics(const Plan& old, Settings& settings) {
  std::vector<ChosenRecord> kept;
  for (const ChosenRecord& chosen : old.chosen) {
    const double* value = std::get_if<double>(&chosen.value);
    if (value == nullptr) continue;
    if (chosen.key == "roofs.cluster_distance" && !settings.roofs.cluster_distance)
      settings.roofs.cluster_distance = *value;
    else if (chosen.key == "roofs.cluster_points" && !settings.roofs.cluster_points)
      settings.roofs.cluster_points = *value;
    else
      continue;
    kept.push_back(chosen);
  }
  return kept;
}

std::uint64_t keep_parts(const fs::path& old_folder, const Plan& old, const Plan& plan, const fs::path& folder) {
  std::unordered_map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < old.areas.size(); ++i) numbers.emplace(old.areas[i].key, i + 1);
  std::uint64_t kept = 0;
  for (std::size_t i = 0; i < plan.areas.size(); ++i) {
    stop_if_asked();
    const auto at = numbers.find(plan.areas[i].key);
    if (at == numbers.end()) continue;
    const fs::path from = parts_of(old, old_folder) / std::to_string(at->second);
    if (!has_part(from, at->first)) continue;
    copy_part(from, parts_of(plan, folder) / std::to_string(i + 1), folder / kPartsFolder / ".copied");
    ++kept;
  }
  return kept;
}

}  // namespace ilot
