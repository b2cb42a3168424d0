// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/opener.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace ilot {

std::string browser_opener() {
  std::istringstream folders(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder) / "xdg-open";
    if (access(program.c_str(), X_OK) == 0) return program.string();
  }
  return {};
}

}  // namespace ilot
