// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/inputs.h"

#include <glob.h>

#include <algorithm>

#include "engine/error.h"
#include "engine/formats/reader.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

void add_folder(const fs::path& folder, std::vector<fs::path>& files) {
  const std::size_t before = files.size();
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error), end;
  while (!error && entry != end) {
    std::error_code ignored;
    if (is_cloud_extension(entry->path()) && entry->is_regular_file(ignored)) files.push_back(entry->path());
    entry.increment(error);
  }
  if (error) throw Error(folder.string() + ": cannot be searched: " + error.message());
  if (files.size() == before) throw Error(folder.string() + ": holds no point cloud; name the files themselves");
}

void add_path(const fs::path& path, std::vector<fs::path>& files) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    add_folder(path, files);
  else
    files.push_back(path);
}

void add_matches(const std::string& pattern, std::vector<fs::path>& files) {
  glob_t found{};
  const int status = ::glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found);
  std::vector<fs::path> matches;
  if (status == 0) matches.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  if (matches.empty()) throw Error(pattern + ": no such file, and nothing matches it as a pattern; check the path");
  for (const fs::path& match : matches) add_path(match, files);
}

}  // namespace

std::vector<fs::path> expand_inputs(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    std::error_code ignored;
    if (fs::exists(argument, ignored))
      add_path(argument, files);
    else if (argument.find_first_of("*?[") != std::string::npos)
      add_matches(argument, files);
    else
      throw Error(argument + ": no such file or folder; check the path");
  }
  for (fs::path& file : files) file = file.lexically_normal();
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace ilot
