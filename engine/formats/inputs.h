// SPDX-License-Identifier: Apache-2.0
// What a user names on the command line, as a list of files.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// Files as they are, globs (when no file of that name exists), folders with all files below that have the extension of
// a cloud. Sorted by path, each once. Throws Error naming the argument that is missing or matches nothing.
std::vector<std::filesystem::path> expand_inputs(const std::vector<std::string>& arguments);

}  // namespace ilot
