// SPDX-License-Identifier: Apache-2.0
// Checks files of models: whether they follow their format, and whether their geometries are valid.
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
  std::vector<std::string> format;  // rules of the file's format that the object breaks
  Faults faults;
};

struct ModelsValidity {
  std::uint64_t objects = 0, invalid = 0;
  std::uint64_t format_faults = 0;     // faults of objects and of the file as a whole
  std::map<int, std::uint64_t> codes;  // number of objects with each code
  bool valid() const { return invalid == 0 && format_faults == 0 && codes.empty(); }
};

// Calls `invalid` for each object that is not valid, in the order of the file, with faults of the file as a whole
// first. A file that cannot be read has code 901. Throws a usage Error for a file of no known format.
ModelsValidity validate_models(const std::filesystem::path& path,
                               const std::function<void(const ObjectValidity&)>& invalid,
                               const ValidityParams& params = {});

}  // namespace ilot
