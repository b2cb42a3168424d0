// SPDX-License-Identifier: Apache-2.0
// Small files that appear whole or not at all.
#pragma once
#include <filesystem>
#include <string_view>

namespace ilot {

// Writes beside `path` under a temporary name, checks every step, flushes to disk and renames into place. On
// a fault nothing stays and an existing file is untouched. Error names the file.
void write_whole_file(const std::filesystem::path& path, std::string_view content);

}  // namespace ilot
