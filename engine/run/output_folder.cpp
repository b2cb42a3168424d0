// SPDX-License-Identifier: Apache-2.0
#include "engine/run/output_folder.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <vector>

#include "engine/error.h"
#include "engine/formats/arrays/array_reader.h"
#include "engine/formats/remote_file.h"
#include "engine/report/product_files.h"
#include "engine/report/resources.h"
#include "engine/report/sha256.h"
#include "engine/run/finished_result.h"
#include "engine/run/memory_budget.h"
#include "engine/run/result_swap.h"
#include "engine/run/run_request.h"
#include "engine/store/columns.h"
#include "engine/store/flushed.h"
#include "engine/store/scratch_file.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kManifest = "manifest.json";

bool is_ours(const fs::path& folder) {
  for (const char* name : {"run.json", ".store", ".new", ".swap", kLockFile})
    if (fs::exists(folder / name)) return true;
  return fs::is_empty(folder);
}

// A store is recognised by its manifest, or by the remains of a write or a removal that was interrupted.
bool is_store(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  if (fs::is_empty(folder) || fs::exists(folder / kLockFile)) return true;
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

// Returns all that runs write in a store: what every store has, and the folders of the passes.
std::vector<std::string> store_folders() {
  std::vector<std::string> names{"blocks", "index", "rejected", "corner", "lattice", "strays", "flushed"};
  for (int pass = 0; pass < kPasses; ++pass) {
    std::istringstream folders(info_of(static_cast<Pass>(pass)).folders);
    for (std::string name; folders >> name;) names.push_back(name);
  }
  return names;
}

// Removes only what runs wrote there. A store that is partly removed must not look complete to --resume. So the
// manifest is renamed first and removed last.
void clear_store(const fs::path& store) {
  if (!fs::is_directory(store)) return;
  if (fs::exists(store / kManifest)) fs::rename(store / kManifest, store / (std::string(kManifest) + ".removed"));
  for (const std::string& name : store_folders()) {
    fs::remove_all(store / name);
    remove_starting_with(store, name + ".");  // the remains of an interrupted write
  }
  remove_starting_with(store, kScratchFile);
  remove_starting_with(store, kManifest);
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  const fs::path whole = fs::canonical(file), top = fs::canonical(folder);
  return std::mismatch(top.begin(), top.end(), whole.begin(), whole.end()).first == top.end();
}

// Inputs must not be where the result is written.
void check_sources(const fs::path& folder, const RunOptions& options, const RunInputs& inputs) {
  std::vector<fs::path> read;
  for (const auto& reader : inputs.readers)
    if (!is_in_memory(reader->info()) && !is_remote(reader->info().path)) read.push_back(reader->info().path);
  for (const fs::path& path : {options.footprints, options.stations, options.train})
    if (!path.empty() && fs::exists(path)) read.push_back(path);
  for (const fs::path& path : read)
    if (lies_in(path, folder))
      throw Error(path.string() + ": is inside of the output folder, whose content would be replaced; give another -o",
                  ExitCode::usage);
}

// Called before anything is changed.
void check_folders(const fs::path& out, const fs::path& store, const RunOptions& options) {
  if (fs::weakly_canonical(out) == fs::weakly_canonical(store))
    throw Error("--store " + store.string() + ": is the output folder; give another", ExitCode::usage);
  if (fs::exists(out)) {
    if (!fs::is_directory(out)) throw Error(out.string() + ": is not a folder", ExitCode::usage);
    if (options.existing == Existing::refuse) {
      const auto holder = folder_holder(out);
      throw Error(out.string() + (holder ? ": " + *holder : std::string(": exists already")) +
                      "; give another -o, --overwrite or --resume",
                  ExitCode::usage);
    }
    if (!is_ours(out))
      throw Error(out.string() + ": contains something else than a run; empty it yourself", ExitCode::usage);
  }
  if (options.store.empty() || !fs::exists(store)) return;
  if (!is_store(store))
    throw Error(store.string() + ": contains something else than a block store; give an empty folder", ExitCode::usage);
}

struct Manifest {
  std::string request;
  std::uint64_t block_points = 0;
};

// Returns the manifest of the interrupted run; nullopt when there is none to resume.
std::optional<Manifest> read_manifest(const fs::path& store) {
  std::ifstream file(store / kManifest);
  if (!file) return std::nullopt;
  std::stringstream text;
  text << file.rdbuf();
  const json value = json::parse(text.str(), nullptr, false);
  if (!value.is_object()) return std::nullopt;
  const json points = value.value("block_points", json());
  return Manifest{value.value("request", json()).dump(), points.is_number_unsigned() ? points.get<std::uint64_t>() : 0};
}

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string((bytes >> 20) + 1) + " MiB";
}

}  // namespace

OutputFolder::OutputFolder(const RunOptions& options, Progress& progress)
    : options_(options),
      path_(options.output),
      store_(options.store.empty() ? options.output / ".store" : options.store),
      block_points_(affordable_block_points(options, thread_count())) {
  check_folders(path_, store_, options);
  lock_.emplace(path_, "or give another -o");
  store_lock_.emplace(store_, "or give another --store");
  store_lock_->remove_empty_folder();
  for (const auto* lock : {&*lock_, &*store_lock_})
    if (!lock->works()) progress.warn("the file system has no locks: see to it yourself that no other run works here");
  if (options.existing == Existing::refuse && fs::exists(path_ / "run.json"))  // of a run that finished earlier
    throw Error(path_.string() + ": exists already; give another -o, --overwrite or --resume", ExitCode::usage);
  finish_swap(path_);
}

Opened OutputFolder::open(const RunInputs& inputs) {
  check_sources(path_, options_, inputs);
  request_ = run_request(options_, inputs);
  Opened opened = Opened::fresh;
  if (options_.existing == Existing::resume) opened = open_resumed();
  if (opened == Opened::finished) return opened;
  old_files_ = files_to_replace(path_);
  if (opened == Opened::fresh) clear_store(store_);
  open_flushed(store_);
  fs::remove_all(staging());
  remove_starting_with(path_, "run.json.");  // the remains of an interrupted write
  if (opened == Opened::fresh) {
    const json manifest{{"request", json::parse(request_)}, {"block_points", block_points_}};
    write_whole_file(store_ / kManifest, manifest.dump(1));
  }
  return opened;
}

Opened OutputFolder::open_resumed() {
  const auto finished = read_finished(path_);
  const std::string other = finished ? request_differences(finished->request, request_, Compare::result) : "";
  if (finished && other.empty()) {
    check_whole(path_, *finished);
    return Opened::finished;
  }
  if (const auto before = read_manifest(store_)) {
    if (const std::string names = request_differences(before->request, request_, Compare::store); !names.empty())
      throw Error("--resume: not the run that was interrupted; different: " + names +
                      " (the same command as then goes on, --overwrite starts afresh)",
                  ExitCode::usage);
    if (before->block_points > 0) block_points_ = before->block_points;
    resumed_ = true;
    return Opened::resumed;
  }
  if (finished && finished->request.empty())
    throw Error(path_.string() +
                    ": is finished, but its run.json does not record what was asked (it is of an older version), so "
                    "that --resume cannot compare; delete the folder yourself or give another -o",
                ExitCode::usage);
  if (finished)
    throw Error(path_.string() + ": is finished, but not by this command; different: " + other +
                    " (--overwrite replaces the result when the new one is whole)",
                ExitCode::usage);
  return Opened::fresh;
}

void OutputFolder::check_space(const RunEstimate& needs) {
  std::uint64_t written = 0;  // by the run that is resumed
  for (const auto& entry : fs::recursive_directory_iterator(store_))
    if (entry.is_regular_file()) written += entry.file_size();
  const std::uint64_t needed = needs.store_bytes - std::min(needs.store_bytes, written);
  const std::uint64_t free_store = free_disk_bytes(store_), free_out = free_disk_bytes(path_);
  const bool one_disk = store_ == path_ / ".store";
  const bool enough =
      one_disk ? needed + needs.result_bytes <= free_out : needed <= free_store && needs.result_bytes <= free_out;
  if (enough) return;
  if (!resumed_) discard();
  throw Error((one_disk ? path_ : store_).string() + ": the run needs at most about " + mebibytes(needed) +
              " for its store, of which " + mebibytes(free_store) + " are free, and " + mebibytes(needs.result_bytes) +
              " for the results, of which " + mebibytes(free_out) +
              " are free; free some or give --store DIR on another disk");
}

void OutputFolder::publish(RunRecord& record) const {
  const std::vector<std::string> names = product_files(staging());
  check_places(path_, old_files_, names);
  for (const std::string& name : names) record.results.push_back({name, fs::file_size(staging() / name)});
  record.request = request_;
  record.result_hash = result_hash(staging());
  write_run_json(record, staging());
  swap_result(path_, old_files_);
}

void OutputFolder::discard() {
  std::error_code ignored;
  fs::remove_all(staging(), ignored);
  if (fs::is_directory(store_, ignored)) clear_store(store_);
  lock_->remove_empty_folder();
}

void OutputFolder::finish(bool keep_store) {
  fs::remove_all(staging());
  if (!keep_store) clear_store(store_);
}

}  // namespace ilot
