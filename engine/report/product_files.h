// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// The report of a result and the folder with its data, directly below OUT. They are made from the result and are no
// part of it.
constexpr const char* kReportFile = "report.html";
constexpr const char* kReportTiles = "report-tiles";

// Returns the regular files below `folder`, as relative paths with `/` between parts, in the order of their bytes. It
// leaves out run.json, the report and names that begin with a dot, all directly below `folder`, and the folder `store`
// when it is inside. Throws Error when the folder cannot be listed.
std::vector<std::string> product_files(const std::filesystem::path& folder, const std::filesystem::path& store = {});

}  // namespace ilot
