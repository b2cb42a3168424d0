// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// Regular files below `folder`, as relative paths with `/` between parts, in the order of their bytes. Left out:
// run.json, report.html and what begins with a dot, each directly below `folder`, and the folder `store` when it is
// inside. Error when the folder cannot be listed.
std::vector<std::string> product_files(const std::filesystem::path& folder, const std::filesystem::path& store = {});

}  // namespace ilot
