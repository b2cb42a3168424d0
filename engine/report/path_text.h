// SPDX-License-Identifier: Apache-2.0
// Paths in JSON, which supports only UTF-8.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace ilot {

// Returns the path as UTF-8. A byte that is not part of UTF-8 is written as \xE9, and so is a backslash (\x5C). Every
// other path does not change. path_of_text is the reverse.
std::string path_text(const std::filesystem::path& path);
std::filesystem::path path_of_text(std::string_view text);

}  // namespace ilot
