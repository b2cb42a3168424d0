// SPDX-License-Identifier: Apache-2.0
// The one table of settings. Everything that the configuration file, --set, --print-config, docs/parameters.md and
// run.json contain about a setting comes from here.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/settings/settings.h"
#include "ilot/parameters.h"

namespace ilot {

// Makes the list that parameters() keeps.
std::vector<Parameter> parameter_table();

// Returns "; did you mean 'planes.epsilon'?" for a key that does not exist, or where all keys are listed. A key without
// its section is compared with the names of the settings alone.
std::string did_you_mean_parameter(std::string_view key);

// Returns the accepted values of the parameter: "a number (m) or \"auto\"".
std::string expected_text(const Parameter& parameter);

}  // namespace ilot
