// SPDX-License-Identifier: Apache-2.0
// Settings in and out as text (ilot/parameters.h), and what only the engine asks of them. The order of precedence is
// the caller's order of calls: defaults, then the file, then each --set.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/settings/settings.h"
#include "ilot/parameters.h"

namespace ilot {

// docs/parameters.md.
std::string parameters_markdown();

// Of all keys and values, in the order of the table; equal settings give equal hashes on every machine.
std::uint64_t settings_hash(const Settings& settings);

// Keys whose values differ: what a refused --resume names.
std::vector<std::string> differing_keys(const Settings& a, const Settings& b);

}  // namespace ilot
