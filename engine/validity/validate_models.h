// SPDX-License-Identifier: Apache-2.0
// Files of models: are they what their format asks, and are their geometries valid?
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engine/validity/validity.h"

namespace ilot {

struct ObjectValidity {
  std::string id;                   // empty: the file as a whole
  std::vector<std::string> format;  // rules of the file's format that it breaks
  Faults faults;
};

struct ModelsValidity {
  std::uint64_t objects = 0, invalid = 0;
  std::uint64_t format_faults = 0;     // of objects and of the file as a whole
  std::map<int, std::uint64_t> codes;  // objects with it, by code
  bool valid() const { return invalid == 0 && format_faults == 0 && codes.empty(); }
};

// Gives each object that is not valid, in the file's order, faults of the file as a whole first. A file that cannot be
// read has code 901. A usage Error for a file of no known format.
ModelsValidity validate_models(const std::filesystem::path& path,
                               const std::function<void(const ObjectValidity&)>& invalid,
                               const ValidityParams& params = {});

}  // namespace ilot
