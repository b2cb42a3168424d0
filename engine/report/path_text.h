// SPDX-License-Identifier: Apache-2.0
// Paths in JSON, which knows UTF-8 alone.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace ilot {

// The path as UTF-8: a byte that is not part of UTF-8 is written \xE9, and so is a backslash (\x5C). Every other path
// stays as it is, and path_of_text gives each back.
std::string path_text(const std::filesystem::path& path);
std::filesystem::path path_of_text(std::string_view text);

}  // namespace ilot
