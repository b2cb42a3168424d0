// SPDX-License-Identifier: Apache-2.0
#include "engine/report/product_files.h"

#include <algorithm>

#include "engine/error.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

bool is_product(const fs::path& relative) {
  const std::string top = relative.begin()->string();
  return !top.starts_with("run.json") && top != kReportFile && top != kReportTiles && !top.starts_with(".");
}

}  // namespace

std::vector<std::string> product_files(const fs::path& folder, const fs::path& store) {
  std::vector<std::string> names;
  std::error_code code;
  for (fs::recursive_directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    const fs::path relative = it->path().lexically_relative(folder);
    std::error_code ignored;
    const bool is_store = !store.empty() && fs::equivalent(it->path(), store, ignored);
    if (is_store || !is_product(relative)) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file(ignored)) {
      names.push_back(relative.generic_string());
    }
  }
  if (code) throw Error(folder.string() + ": cannot list the products: " + code.message());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace ilot
