// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// The files that INPUT... means, each once, in the order of their paths, so that the order of arguments does
// not matter: a file stands for itself, a folder for the point clouds anywhere below it (hidden folders left
// out), a pattern with * ? [ for what it matches. Error with ExitCode::usage for what does not exist or holds
// no point cloud.
std::vector<std::filesystem::path> expand_inputs(const std::vector<std::string>& arguments);

}  // namespace ilot
