// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/kept_run.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/error.h"
#include "engine/report/path_text.h"
#include "engine/run/finished_result.h"
#include "engine/run/folder_lock.h"
#include "engine/run/inputs/area_in_crs.h"
#include "engine/run/run_context.h"
#include "engine/run/run_request.h"
#include "engine/settings/config.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path store_of(const KeptRunPlaces& places) {
  return places.store.empty() ? places.out / ".store" : places.store;
}

json record_of(const fs::path& out) {
  std::ifstream file(out / "run.json");
  if (!file) throw Error(out.string() + ": contains no finished run (run.json is missing)", ExitCode::usage);
  json record = json::parse(file, nullptr, false);
  if (!record.is_object() || !record.value("request", json()).is_object() || !record.contains("parameters"))
    throw Error((out / "run.json").string() + ": does not say what was asked; the run is of an older version",
                ExitCode::usage);
  return record;
}

void check_store(const KeptRunPlaces& places) {
  const fs::path store = store_of(places);
  if (!fs::exists(store / "index"))
    throw Error(store.string() + ": there is no store to replay from; make the run again with --keep-store",
                ExitCode::usage);
  for (const fs::path& folder : {places.out, store})
    if (const auto holder = folder_holder(folder))
      throw Error(folder.string() + ": " + *holder + "; wait for its end", ExitCode::usage);
}

fs::path file_of(const json& file) {
  return file.is_object() ? path_of_text(file.value("path", "")) : fs::path();
}

Settings settings_of(const json& parameters) {
  Settings settings;
  for (const auto& [key, value] : parameters.items())
    apply_assignment(settings, key + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
  return settings;
}

// Removes the parts of the request that a replay does not need unchanged: the differences show the effect of another
// program version, and some products do not depend on the stations or the area.
std::string without_unneeded(const std::string& before, const std::string& now, const RunOptions& options) {
  json old = json::parse(before);
  const json other = json::parse(now);
  const auto made = [&](const char* product) {
    return std::find(options.products.begin(), options.products.end(), product) != options.products.end();
  };
  for (const char* key : {"version", "git_hash"}) old[key] = other[key];
  if (!made("facades")) old["stations"] = other["stations"];
  if (!made("facades") && !made("streets")) old["area"] = other["area"];
  return old.dump();
}

// Returns the box for which products were asked, without polygons.
std::optional<Area> area_of(const json& area) {
  if (!area.is_object()) return std::nullopt;
  const auto box = area.value("box", std::vector<double>{});
  if (box.size() != 4) return std::nullopt;
  return Area{box[0], box[1], box[2], box[3], {}};
}

std::string what_to_give(const std::string& names) {
  std::string options;
  for (const auto& [name, option] :
       {std::pair{"stations", "--stations"}, std::pair{"edits", "--edits"}, std::pair{"area", "--within"}})
    if (names.find(name) != std::string::npos) options += (options.empty() ? "" : " and ") + std::string(option);
  return options.empty() ? "" : " (give " + options + " as the run was given it)";
}

}  // namespace

ScratchStore::ScratchStore(const fs::path& kept, fs::path scratch) : folder_(std::move(scratch)) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  const fs::path from = fs::canonical(kept);
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const fs::path to = folder_ / entry.path().lexically_relative(from);
    if (entry.is_directory())
      fs::create_directories(to);
    else if (entry.path().filename() != kLockFile)
      fs::create_symlink(entry.path(), to);
  }
}

ScratchStore::~ScratchStore() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

RunOptions kept_options(const KeptRunPlaces& places) {
  const json record = record_of(places.out);
  check_store(places);
  const json& request = record["request"];
  RunOptions options;
  options.output = places.out;
  options.store = store_of(places);
  options.stations = places.stations;
  options.edits = places.edits;
  options.settings = settings_of(record["parameters"]);
  options.products = request.value("products", std::vector<std::string>{});
  for (const json& input : request.value("inputs", json::array())) options.inputs.push_back(file_of(input));
  options.footprints = file_of(request.value("footprints", json()));
  options.id_field = request.value("id_field", std::string());
  options.train = file_of(request.value("train", json()));
  options.crs = request.value("crs", "");
  options.to_crs = request.value("to_crs", "");
  if (const std::string words = request.value("text_dialect", ""); !words.empty())
    options.dialect = dialect_of_words(words);
  options.clouds = request.value("clouds", true);
  options.area = area_of(request.value("area", json()));
  return options;
}

KeptRun::KeptRun(const KeptRunPlaces& places, const fs::path& scratch, Progress& progress)
    : options_(kept_options(places)), training_{options_.train, places.learn} {
  RunRecord record;
  Progress silent;  // the run has reported everything
  inputs_ = open_inputs(options_, silent, record);
  if (places.within) options_.area = area_in_crs(*places.within, inputs_, silent, record);
  const auto before = read_finished(options_.output);
  const std::string now = run_request(options_, inputs_);
  const std::string other = request_differences(without_unneeded(before->request, now, options_), now, Compare::store);
  if (!other.empty())
    throw Error(options_.output.string() + ": cannot be replayed, since what it was made from is different now: " +
                    other + what_to_give(other),
                ExitCode::usage);
  context_ = pass_context(options_, inputs_, options_.settings.index.block_points, progress);
  scratch_.emplace(options_.store, scratch);
  index_.emplace(open_index(scratch_->folder(), common_lattice(inputs_.readers, inputs_.crs.metres_per_unit,
                                                               options_.settings.index.finest_step)));
  set_lattice(options_, inputs_, index_->lattice, context_);
  context_.corner = index_->corner;
}

bool KeptRun::made(const char* product) const {
  return std::find(options_.products.begin(), options_.products.end(), product) != options_.products.end();
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace ilot
