// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "engine/validity/validate_models.h"

namespace ilot {

// Checks one file of models. Prints a line for each object that is not valid, then a line for the file. If `json` is
// given, appends the entry of the file to it and prints nothing. Returns true when the file is valid.
bool print_models_validity(const std::filesystem::path& file, const ValidityParams& params, std::string* json);

}  // namespace ilot
