// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/open_inputs.h"

#include <map>
#include <set>

#include "engine/error.h"
#include "engine/formats/arrays/array_reader.h"
#include "engine/formats/crs.h"
#include "engine/formats/file.h"
#include "engine/formats/file_date.h"
#include "engine/pass/pass.h"
#include "engine/run/inputs/input_crs.h"
#include "engine/run/inputs/read_edits.h"
#include "engine/run/inputs/read_stations.h"
#include "engine/run/inputs/row_stations.h"

namespace ilot {
namespace {

void skip(const std::filesystem::path& path, const std::string& reason, const RunOptions& options, Progress& progress,
          RunRecord& record) {
  if (options.strict) throw Error(reason);
  const std::string prefix = path.string() + ": ";
  progress.input_skipped(path.string(), reason.starts_with(prefix) ? reason.substr(prefix.size()) : reason);
  record.skipped.push_back({"input", path.string(), reason});
}

std::unique_ptr<PointReader> try_open(const std::filesystem::path& path, const OpenOptions& open,
                                      const RunOptions& options, Progress& progress, RunRecord& record) {
  try {
    auto reader = open_cloud(path, open);
    if (reader->info().points > 0) return reader;
    if (options.inputs.size() == 1) throw Error(path.string() + ": contains no points");
    skip(path, path.string() + ": contains no points", options, progress, record);
  } catch (const Error& fault) {
    if (options.inputs.size() == 1) throw;
    skip(path, fault.what(), options, progress, record);
  }
  return nullptr;
}

// Points that the header declares and the file does not contain count as skipped.
void note_input(const CloudInfo& info, const RunOptions& options, Progress& progress, RunRecord& record) {
  progress.input_ok(info.path.string(), info.points);
  for (const std::string& warning : info.warnings) {
    progress.warn(warning);
    record.warnings.push_back(warning);
  }
  if (info.declared_points > info.points) {
    skip(info.path,
         info.path.string() + ": " + std::to_string(info.points) + " of " + std::to_string(info.declared_points) +
             " points can be read; these are used",
         options, progress, record);
  }
  const std::uint64_t bytes = is_in_memory(info) ? 0 : bytes_of_file(info.path);
  record.inputs.push_back({info.path.string(), info.format, crs_name(info.crs), info.points, bytes, "", info.dialect});
}

// Writes one line for all inputs that write numbers in the same way.
void note_dialects(const RunInputs& inputs, Progress& progress) {
  std::map<std::string, std::vector<std::string>> files;
  for (const auto& reader : inputs.readers)
    if (const CloudInfo& info = reader->info(); !info.dialect.empty())
      files[info.dialect].push_back(info.path.string());
  for (const auto& [dialect, paths] : files) {
    const std::string more = paths.size() > 1 ? " and " + grouped(paths.size() - 1) + " more" : "";
    progress.note(paths[0] + more + ": text " + dialect);
  }
}

// The labels of a cloud in memory are called as the cloud.
void refuse_equal_names(const std::vector<ArrayCloud>& clouds) {
  std::set<std::string> names;
  for (const ArrayCloud& cloud : clouds)
    if (!names.insert(cloud.name).second)
      throw Error("two clouds in memory are called \"" + cloud.name + "\": their labels need names of their own",
                  ExitCode::usage);
}

}  // namespace

RunInputs open_inputs(const RunOptions& options, Progress& progress, RunRecord& record) {
  RunInputs inputs;
  const OpenOptions open{options.dialect, !options.crs.empty() && crs_from_text(options.crs).geographic};
  for (const auto& path : options.inputs) {
    stop_if_asked();
    auto reader = try_open(path, open, options, progress, record);
    if (!reader) continue;
    note_input(reader->info(), options, progress, record);
    inputs.points += reader->info().points;
    inputs.readers.push_back(std::move(reader));
  }
  refuse_equal_names(options.arrays);
  for (const ArrayCloud& cloud : options.arrays) {
    auto reader = open_arrays(cloud);
    note_input(reader->info(), options, progress, record);
    inputs.points += reader->info().points;
    inputs.readers.push_back(std::move(reader));
  }
  if (inputs.readers.empty()) throw Error("none of the inputs can be used; see the lines above");
  note_dialects(inputs, progress);
  for (const auto& reader : inputs.readers)
    inputs.sources.push_back({reader->info().path.filename().string(), file_date(reader->info())});
  const double height_factor = resolve_crs(inputs, options, progress, record);
  if (!options.stations.empty()) {
    inputs.stations = read_stations(options.stations);
    for (Station& station : inputs.stations) station.position.z *= height_factor;
  } else {
    for (const auto& reader : inputs.readers)
      inputs.stations.insert(inputs.stations.end(), reader->info().stations.begin(), reader->info().stations.end());
  }
  inputs.row_stations = row_stations(inputs.readers, inputs.stations,
                                     options.stations.empty() ? StationsFrom::inputs : StationsFrom::file);
  inputs.edits = read_edits(options.edits);
  if (inputs.crs.unit_assumed) progress.warn("no input says its unit: metres are assumed; --crs EPSG:n says it");
  record.unit_assumed = inputs.crs.unit_assumed;
  return inputs;
}

}  // namespace ilot
