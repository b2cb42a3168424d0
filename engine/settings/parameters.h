// SPDX-License-Identifier: Apache-2.0
// The one table of settings: what the configuration file, --set, --print-config, docs/parameters.md and
// run.json know of a setting comes from here.
#pragma once
#include <string>
#include <string_view>

#include "engine/settings/settings.h"
#include "ilot/parameters.h"

namespace ilot {

// The key with the smallest edit distance (insert, delete, replace, swap of neighbours), ties to the earlier
// one.
const Parameter& nearest_parameter(std::string_view key);

// What the parameter takes: "a number (m) or \"auto\"".
std::string expected_text(const Parameter& parameter);

}  // namespace ilot
