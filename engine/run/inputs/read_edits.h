// SPDX-License-Identifier: Apache-2.0
// Reads tables of corrections by hand. Faults are Errors with ExitCode::usage and FILE:LINE.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/edit.h"

namespace ilot {

// A table is CSV as spreadsheets save it: separated by commas, semicolons or tabs (then numbers may have a decimal
// comma), fields in quotes or not, UTF-8. The first line names the columns (kEditColumns), in any order; columns that
// no line needs may be missing. Each further line is an edit. Empty lines and lines that begin with # are left out.
// Throws for a file that cannot be read, is larger than 64 MiB or has no such first line, and for a line that lacks
// what its edit needs.
std::vector<Edit> read_edits(const std::filesystem::path& path);
std::vector<Edit> parse_edits(std::string_view text, const std::string& name);

// The edits of all files, one after the other.
std::vector<Edit> read_edits(std::span<const std::filesystem::path> paths);

}  // namespace ilot
