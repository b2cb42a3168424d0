// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/result_folder.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "engine/error.h"
#include "engine/report/path_text.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

std::vector<ResultRecord> files_of_run(const Json& run) {
  std::vector<ResultRecord> files;
  for (const Json& file : run.at("results"))
    files.push_back({path_of_text(file.at("path").get<std::string>()).string(), file.at("bytes").get<std::uint64_t>()});
  return files;
}

}  // namespace

bool ResultFolder::has(const std::string& file) const {
  return std::any_of(files.begin(), files.end(), [&](const ResultRecord& f) { return f.path == file; });
}

bool ResultFolder::makes(const char* product) const {
  const Json& products = run.at("products");
  return std::find(products.begin(), products.end(), product) != products.end();
}

std::uint64_t ResultFolder::count(const char* product, const char* what) const {
  const Json counts = run.value("counts", Json::object()).value(product, Json::object());
  return counts.is_object() ? counts.value(what, std::uint64_t{0}) : 0;
}

ResultFolder open_result(const std::filesystem::path& path) {
  std::ifstream file(path / "run.json");
  if (!file)
    throw Error(path.string() + ": has no run.json, so it is no finished result; give the OUT of `ilot run -o OUT`",
                ExitCode::usage);
  std::stringstream text;
  text << file.rdbuf();
  ResultFolder folder;
  folder.path = path;
  folder.run = Json::parse(text.str(), nullptr, false);
  try {
    folder.files = files_of_run(folder.run);
    folder.makes("");
    folder.memory_bytes = folder.run.value("memory_bytes", folder.memory_bytes);
    folder.metres_per_unit = folder.run.value("crs", Json::object()).value("metres_per_unit", 1.0);
  } catch (const Json::exception&) {
    throw Error((path / "run.json").string() + ": is not as a run writes it; run again to have a report",
                ExitCode::usage);
  }
  return folder;
}

}  // namespace ilot
