// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// Returns the files that INPUT... selects, each once, in the order of their paths, so that the order of arguments does
// not matter. A file selects itself, a folder the point clouds at any depth below it (hidden folders are left out), a
// pattern with * ? [ the matching files. Throws Error with ExitCode::usage for an argument that does not exist or has
// no point cloud.
std::vector<std::filesystem::path> expand_inputs(const std::vector<std::string>& arguments);

}  // namespace ilot
