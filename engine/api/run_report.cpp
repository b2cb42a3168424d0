// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/error.h"
#include "engine/report/path_text.h"
#include "ilot/run.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

std::vector<SkippedRecord> skipped_of(const Json& list) {
  std::vector<SkippedRecord> out;
  for (const Json& s : list) out.push_back({s.at("what"), s.at("where"), s.at("reason")});
  return out;
}

RunReport report_of(const Json& j, const std::filesystem::path& folder) {
  RunReport r;
  r.folder = folder;
  r.exit = static_cast<ExitCode>(j.at("exit_code").get<int>());
  r.products = j.at("products").get<std::vector<std::string>>();
  const Json& points = j.at("counts").at("points");
  r.points_read = points.at("read");
  r.points_labelled = points.at("labelled");
  r.points_unlabelled = points.at("unlabelled");
  r.points_rejected = j.at("rejected").get<std::map<std::string, std::uint64_t>>();
  r.skipped = skipped_of(j.at("skipped"));
  r.warnings = j.at("warnings").get<std::vector<std::string>>();
  for (const Json& c : j.at("chosen")) {
    const Json& value = c.at("value");
    r.chosen[c.at("key")] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  for (const Json& file : j.at("results")) r.files.push_back(path_of_text(file.at("path").get<std::string>()));
  for (const Json& input : j.at("inputs"))
    if (input.contains("output")) r.clouds.push_back(path_of_text(input.at("output").get<std::string>()));
  r.seconds = j.at("seconds");
  r.peak_memory_bytes = j.at("peak_rss_bytes");
  r.result_hash = j.at("result_hash");
  return r;
}

}  // namespace

RunReport read_run(const std::filesystem::path& run_folder) {
  const std::filesystem::path path = run_folder / "run.json";
  std::ifstream file(path);
  if (!file) throw Error(path.string() + ": is missing: this is not the folder of a finished run", ExitCode::usage);
  std::stringstream text;
  text << file.rdbuf();
  try {
    return report_of(Json::parse(text.str()), run_folder);
  } catch (const Json::exception& fault) {
    throw Error(path.string() + ": is damaged: " + fault.what());
  }
}

}  // namespace ilot
