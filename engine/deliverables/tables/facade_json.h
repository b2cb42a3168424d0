// SPDX-License-Identifier: Apache-2.0
// facades/facade-NNN.json; keys in docs/outputs.md.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/model/facade.h"

namespace ilot {

// The file is complete or absent. Numbers are the shortest ones that are read back as the same bits.
void write_facade_json(const std::filesystem::path& path, const Facade& facade);
std::string facade_json(const Facade& facade);

// Reads the file. The input is not trusted: shapes and numbers are checked, and an Error names file and place.
Facade read_facade_json(const std::filesystem::path& path);
Facade parse_facade_json(std::string_view text, const std::string& name);

}  // namespace ilot
