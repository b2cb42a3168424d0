// SPDX-License-Identifier: Apache-2.0
// Reads and writes settings as text (ilot/parameters.h), with functions that only the engine needs. The precedence is
// the order of the caller's calls: defaults, then the file, then each --set.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/settings/settings.h"
#include "ilot/parameters.h"

namespace ilot {

// Returns the text of docs/parameters.md.
std::string parameters_markdown();

// Returns a hash of all keys and values, in the order of the table. Equal settings give equal hashes on every machine.
std::uint64_t settings_hash(const Settings& settings);

// Returns the keys whose values differ; a refused --resume names them.
std::vector<std::string> differing_keys(const Settings& a, const Settings& b);

}  // namespace ilot
