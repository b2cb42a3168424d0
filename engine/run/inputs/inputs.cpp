// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/inputs.h"

#include <glob.h>

#include <algorithm>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/formats/remote_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> matches(const std::string& pattern) {
  glob_t found{};
  std::vector<fs::path> paths;
  if (glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0) {
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  return paths;
}

void add_folder(std::vector<fs::path>& files, const fs::path& folder) {
  std::error_code code;
  const std::size_t before = files.size();
  for (fs::recursive_directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    std::error_code ignored;
    if (it->path().filename().string().starts_with(".")) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file(ignored) && is_cloud_extension(it->path())) {
      files.push_back(it->path());
    }
  }
  if (code) throw Error(folder.string() + ": cannot be listed: " + code.message(), ExitCode::usage);
  if (files.size() == before) throw Error(folder.string() + ": contains no point cloud", ExitCode::usage);
}

}  // namespace

std::vector<fs::path> expand_inputs(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    if (is_remote(argument)) {
      files.emplace_back(argument);
      continue;
    }
    std::error_code code;
    std::vector<fs::path> found{argument};
    if (!fs::exists(argument, code)) found = matches(argument);
    if (found.empty()) throw Error(argument + ": no such file or folder", ExitCode::usage);
    for (const fs::path& path : found) {
      if (fs::is_directory(path, code)) {
        add_folder(files, path);
      } else {
        files.push_back(path);
      }
    }
  }
  for (fs::path& file : files)
    if (!is_remote(file)) file = file.lexically_normal();
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace ilot
