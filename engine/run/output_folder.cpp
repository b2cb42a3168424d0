// SPDX-License-Identifier: Apache-2.0
#include "engine/run/output_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <vector>

#include "engine/error.h"
#include "engine/report/resources.h"
#include "engine/settings/config.h"
#include "engine/store/flushed.h"
#include "engine/version.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json manifest_inputs(const RunInputs& inputs) {
  json list = json::array();
  for (const auto& reader : inputs.readers) {
    const CloudInfo& info = reader->info();
    std::error_code ignored;
    const auto changed = fs::last_write_time(info.path, ignored).time_since_epoch().count();
    list.push_back(
        {fs::absolute(info.path).lexically_normal().string(), info.points, fs::file_size(info.path, ignored), changed});
  }
  return list;
}

json file_json(const std::filesystem::path& path) {
  if (path.empty()) return nullptr;
  std::error_code ignored;
  return {fs::absolute(path).lexically_normal().string(), fs::file_size(path, ignored),
          fs::last_write_time(path, ignored).time_since_epoch().count()};
}

json stations_json(const std::vector<Station>& stations) {
  json list = json::array();
  for (const Station& s : stations)
    list.push_back(
        {s.position.x, s.position.y, s.position.z, s.azimuth_step, s.elevation_step, s.axis.x, s.axis.y, s.axis.z});
  return list;
}

json area_json(const std::optional<Area>& area) {
  if (!area) return nullptr;
  return {area->min_x, area->min_y, area->max_x, area->max_y, area->rings};
}

// What must be equal for a run to go on where another stopped. block_points is the exception: the first run's counts.
json manifest(const RunOptions& options, const RunInputs& inputs, std::uint64_t block_points) {
  Settings settings = options.settings;
  settings.index.block_points = 0;
  return {{"version", version()},
          {"git_hash", git_hash()},
          {"inputs", manifest_inputs(inputs)},
          {"settings", json::parse(settings_json(settings))},
          {"area", area_json(options.area)},
          {"footprints", file_json(options.footprints)},
          {"train", file_json(options.train)},
          {"stations", stations_json(inputs.stations)},
          {"products", options.products},
          {"crs", options.crs},
          {"to_crs", options.to_crs},
          {"text_dialect", options.dialect ? words_of(*options.dialect) : ""},
          {"block_points", block_points}};
}

std::string differences(const json& before, const json& now) {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  for (const auto& [key, value] : now.items()) {
    if (key == "block_points" || before.value(key, json()) == value) continue;
    if (key != "settings" || !before.contains(key)) {
      add(key);
      continue;
    }
    for (const auto& [name, setting] : value.items())
      if (before[key].value(name, json()) != setting) add(name);
  }
  return names;
}

constexpr const char* kManifest = "manifest.json";

bool is_ours(const fs::path& folder) {
  return fs::is_empty(folder) || fs::exists(folder / "run.json") || fs::exists(folder / ".store") ||
         fs::exists(folder / ".new");
}

// A store is known by its manifest, or by what a write or a removal that was cut short left of it.
bool is_store(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  if (fs::is_empty(folder)) return true;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(kManifest)) return true;
  return false;
}

void remove_starting_with(const fs::path& folder, std::string_view beginning) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(beginning)) found.push_back(entry.path());
  for (const fs::path& path : found) fs::remove(path);
}

// Takes away what runs put there and nothing else. A store that is half gone must not look whole to --resume, so it
// loses the name of its manifest first and the manifest itself last.
void clear_store(const fs::path& store) {
  if (!fs::is_directory(store)) return;
  if (fs::exists(store / kManifest)) fs::rename(store / kManifest, store / (std::string(kManifest) + ".removed"));
  for (const char* name : {"runs", "blocks", "cells", "colours", "sources", "ground", "roofs", "streets", "index",
                           "rejected", "corner", "lattice", "flushed"})
    fs::remove_all(store / name);
  remove_starting_with(store, kManifest);
}

void remove_products(const fs::path& folder) {
  clear_store(folder / ".store");
  for (const char* name : {"points", "planes.csv", "planes.gpkg", "planes_neighbours.csv", "shapes.csv", "density",
                           "roofs", "facades", "streets", "run.json", ".new", ".store"})
    fs::remove_all(folder / name);
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  const fs::path whole = fs::canonical(file), top = fs::canonical(folder);
  return std::mismatch(top.begin(), top.end(), whole.begin(), whole.end()).first == top.end();
}

// An existing folder is touched only when it is a run's, and never when it holds what is to be read.
void check_existing(const fs::path& folder, const RunOptions& options, const RunInputs& inputs) {
  if (options.existing == Existing::refuse)
    throw Error(folder.string() + ": exists already; give another -o, --overwrite or --resume", ExitCode::usage);
  if (!fs::is_directory(folder)) throw Error(folder.string() + ": is not a folder", ExitCode::usage);
  if (!is_ours(folder))
    throw Error(folder.string() + ": holds something else than a run; empty it yourself", ExitCode::usage);
  std::vector<fs::path> read;
  for (const auto& reader : inputs.readers) read.push_back(reader->info().path);
  for (const fs::path& path : {options.footprints, options.stations})
    if (!path.empty() && fs::exists(path)) read.push_back(path);
  for (const fs::path& path : read)
    if (lies_in(path, folder))
      throw Error(path.string() + ": lies in the output folder, whose content would be replaced; give another -o",
                  ExitCode::usage);
}

std::optional<json> read_manifest(const fs::path& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  std::stringstream text;
  text << file.rdbuf();
  json value = json::parse(text.str(), nullptr, false);
  if (value.is_discarded()) return std::nullopt;
  return value;
}

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string((bytes >> 20) + 1) + " MiB";
}

}  // namespace

std::uint64_t memory_to_fill(const RunOptions& options) {
  constexpr std::uint64_t kLeftOut = 12u << 20;
  return options.memory_bytes - std::min(options.memory_bytes / 2, kLeftOut);
}

std::uint64_t memory_for_blocks(const RunOptions& options) {
  constexpr std::uint64_t kBase = 56u << 20;
  return std::max(options.memory_bytes, 2 * kBase) - kBase;
}

std::uint64_t affordable_block_points(const RunOptions& options, int threads) {
  constexpr std::uint64_t kPerPoint = 96;  // of a block in work, its surroundings included
  constexpr std::uint64_t kLeast = 1u << 14;
  const std::uint64_t affordable = memory_for_blocks(options) / (kPerPoint * static_cast<std::uint64_t>(threads));
  return std::min(options.settings.index.block_points, std::max(kLeast, affordable));
}

bool is_finished(const RunOptions& options, const RunInputs& inputs) {
  const fs::path store = options.store.empty() ? options.output / ".store" : options.store;
  const auto record = read_manifest(options.output / "run.json");
  if (!record || fs::exists(store / kManifest) ||
      record->value("parameters_hash", "") != fmt::format("{:016x}", settings_hash(options.settings)))
    return false;
  if ((*record)["products"] != json(options.products)) return false;
  if (options.clouds && !fs::exists(options.output / "points")) return false;
  const json& read = (*record)["inputs"];
  if (read.size() != inputs.readers.size()) return false;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const CloudInfo& info = inputs.readers[i]->info();
    if (read[i].value("path", "") != info.path.string() || read[i].value("points", std::uint64_t{0}) != info.points)
      return false;
  }
  return true;
}

void clear_finished_store(const RunOptions& options) {
  const fs::path store = options.store.empty() ? options.output / ".store" : options.store;
  if (options.keep_store || !fs::exists(store)) return;
  clear_store(store);
  if (fs::is_empty(store)) fs::remove(store);
}

OutputFolder::OutputFolder(const RunOptions& options, const RunInputs& inputs)
    : path_(options.output),
      store_(options.store.empty() ? options.output / ".store" : options.store),
      block_points_(affordable_block_points(options, thread_count())) {
  const fs::path manifest_path = store_ / kManifest;
  const bool exists = fs::exists(path_);
  if (exists) check_existing(path_, options, inputs);
  if (!options.store.empty() && fs::exists(store_) && !is_store(store_))
    throw Error(store_.string() + ": holds something else than a block store; give an empty folder", ExitCode::usage);
  if (exists && options.existing == Existing::overwrite) remove_products(path_);
  const json now = manifest(options, inputs, block_points_);
  const auto before = options.existing == Existing::resume ? read_manifest(manifest_path) : std::nullopt;
  if (before) {
    if (const std::string names = differences(*before, now); !names.empty())
      throw Error("--resume: not the run that was interrupted; different: " + names +
                      " (the same command as then goes on, --overwrite starts afresh)",
                  ExitCode::usage);
    block_points_ = before->value("block_points", block_points_);
  } else {
    clear_store(store_);
  }
  std::error_code problem;
  fs::create_directories(store_, problem);
  if (!problem) fs::create_directories(path_, problem);
  if (problem) {
    discard();
    throw Error((fs::is_directory(store_) ? path_ : store_).string() + ": cannot be created: " + problem.message() +
                "; give another place");
  }
  open_flushed(store_);
  fs::remove_all(staging());
  remove_starting_with(path_, "run.json.");  // what a write that was cut short left
  if (!before) write_whole_file(manifest_path, now.dump(1));
}

void OutputFolder::check_space(std::uint64_t points, std::uint64_t output_bytes) const {
  std::uint64_t written = 0;  // by the run that is resumed
  for (const auto& entry : fs::recursive_directory_iterator(store_))
    if (entry.is_regular_file()) written += entry.file_size();
  const std::uint64_t store_bytes = points * kStoreBytesPerPoint;
  const std::uint64_t needed = store_bytes - std::min(store_bytes, written);
  const std::uint64_t free_store = free_disk_bytes(store_), free_out = free_disk_bytes(path_);
  const bool one_disk = store_ == path_ / ".store";
  const bool enough = one_disk ? needed + output_bytes <= free_out : needed <= free_store && output_bytes <= free_out;
  if (enough) return;
  if (written == 0) discard();
  throw Error((one_disk ? path_ : store_).string() + ": the run needs about " + mebibytes(needed) +
              " for its store, of which " + mebibytes(free_store) + " are free, and " + mebibytes(output_bytes) +
              " for the results, of which " + mebibytes(free_out) +
              " are free; free some or give --store DIR on another disk");
}

void OutputFolder::publish() const {
  for (const auto& entry : fs::directory_iterator(staging())) {
    const fs::path target = path_ / entry.path().filename();
    fs::remove_all(target);
    fs::rename(entry.path(), target);
  }
}

void OutputFolder::discard() const {
  std::error_code ignored;
  fs::remove_all(staging(), ignored);
  if (fs::is_directory(store_, ignored)) clear_store(store_);
  for (const fs::path& folder : {store_, path_})
    if (fs::is_directory(folder, ignored)) fs::remove(folder, ignored);
}

void OutputFolder::finish(bool keep_store) const {
  fs::remove_all(staging());
  if (keep_store) return;
  clear_store(store_);
  if (fs::is_empty(store_)) fs::remove(store_);
}

}  // namespace ilot
