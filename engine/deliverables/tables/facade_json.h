// SPDX-License-Identifier: Apache-2.0
// facades/facade-NNN.json; keys in docs/outputs.md.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/model/facade.h"

namespace ilot {

// Written whole or not at all. Numbers are the shortest that read back to the same bits.
void write_facade_json(const std::filesystem::path& path, const Facade& facade);
std::string facade_json(const Facade& facade);

// The way back. Input is hostile: shapes and numbers are checked, an Error names file and place.
Facade read_facade_json(const std::filesystem::path& path);
Facade parse_facade_json(std::string_view text, const std::string& name);

}  // namespace ilot
