// SPDX-License-Identifier: Apache-2.0
// Settings in and out as text. The order of precedence is the caller's order of calls: defaults, then the
// file, then each --set. Every fault is an Error with ExitCode::usage that names the place, the range or the
// nearest key.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/settings/settings.h"

namespace ilot {

// Overwrites the settings that the TOML file gives and leaves the others. Faults read "FILE:LINE:COLUMN:
// ...". On a fault nothing is changed. Files above 1 MiB are refused.
void load_config(Settings& settings, const std::filesystem::path& path);

// The same on text; `name` stands for the file in messages.
void load_config_text(Settings& settings, std::string_view text, const std::string& name);

// "planes.epsilon=0.02", "classes.noise=[7, 18]", "planes.epsilon=auto". Faults read "--set ASSIGNMENT: ...".
void apply_assignment(Settings& settings, std::string_view assignment);

// A commented TOML of all settings with default, unit, range and one line of meaning; load_config reads it
// back to the same settings.
std::string print_config(const Settings& settings);

// docs/parameters.md.
std::string parameters_markdown();

// One JSON object, keys as in the table, `auto` as a string.
std::string settings_json(const Settings& settings);

// Of all keys and values, in the order of the table; equal settings give equal hashes on every machine.
std::uint64_t settings_hash(const Settings& settings);

// Keys whose values differ: what a refused --resume names.
std::vector<std::string> differing_keys(const Settings& a, const Settings& b);

}  // namespace ilot
