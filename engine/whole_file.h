// SPDX-License-Identifier: Apache-2.0
// Small files that appear complete or not at all.
#pragma once
#include <filesystem>
#include <string_view>

namespace ilot {

// Writes beside `path` under a temporary name, checks every step, flushes to disk and renames the file. After a fault
// no new file remains and an existing file is unchanged. An Error names the file.
void write_whole_file(const std::filesystem::path& path, std::string_view content);

}  // namespace ilot
