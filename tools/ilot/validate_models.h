// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "engine/validity/validate_models.h"

namespace ilot {

// Looks at one file of models and prints a line for each object that is not valid, then a line for the file; or, as
// `json`, appends the file's entry to it and prints nothing. True when the file is valid.
bool print_models_validity(const std::filesystem::path& file, std::string* json);

}  // namespace ilot
