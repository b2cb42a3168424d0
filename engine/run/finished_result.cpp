// SPDX-License-Identifier: Apache-2.0
#include "engine/run/finished_result.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/report/path_text.h"
#include "engine/run/result_swap.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// The file may have been edited: a value that does not have the expected type counts as not recorded.
std::optional<std::vector<ResultRecord>> files_of(const json& record) {
  const json list = record.value("results", json());
  if (!list.is_array()) return std::nullopt;
  std::vector<ResultRecord> files;
  for (const json& entry : list) {
    if (!entry.is_object() || !entry.contains("path") || !entry["path"].is_string() || !entry.contains("bytes") ||
        !entry["bytes"].is_number_unsigned())
      return std::nullopt;
    const fs::path path = path_of_text(entry["path"].get<std::string>());
    if (!is_inside(path)) return std::nullopt;
    files.push_back({path.string(), entry["bytes"].get<std::uint64_t>()});
  }
  return files;
}

}  // namespace

std::optional<FinishedResult> read_finished(const fs::path& out) {
  std::ifstream file(out / "run.json");
  if (!file) return std::nullopt;
  std::stringstream text;
  text << file.rdbuf();
  const json record = json::parse(text.str(), nullptr, false);
  if (!record.is_object()) return std::nullopt;
  FinishedResult result;
  if (const json request = record.value("request", json()); request.is_object()) result.request = request.dump();
  const auto files = files_of(record);
  result.listed = files.has_value();
  if (files) result.files = *files;
  return result;
}

std::vector<std::string> files_to_replace(const fs::path& out) {
  if (!fs::exists(out / "run.json")) return {};
  const auto result = read_finished(out);
  if (!result || !result->listed)
    throw Error((out / "run.json").string() +
                    ": does not list the files of its result (it is of an older version, or damaged), so that they "
                    "cannot be distinguished from others; delete the folder yourself or give another -o",
                ExitCode::usage);
  std::vector<std::string> names;
  for (const ResultRecord& file : result->files) names.push_back(file.path);
  return names;
}

void check_whole(const fs::path& out, const FinishedResult& result) {
  for (const ResultRecord& file : result.files) {
    std::error_code problem;
    const std::uint64_t bytes = fs::file_size(out / file.path, problem);
    if (!problem && bytes == file.bytes) continue;
    throw Error((out / file.path).string() + ": " + (problem ? "is missing" : "has another size than the run gave it") +
                    "; --overwrite makes the whole result again",
                ExitCode::usage);
  }
}

}  // namespace ilot
