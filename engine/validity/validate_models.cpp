// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_models.h"

#include <utility>

#include "engine/deliverables/solids/solid_file.h"
#include "engine/error.h"

namespace ilot {

ModelsValidity validate_models(const std::filesystem::path& path,
                               const std::function<void(const ObjectValidity&)>& invalid,
                               const ValidityParams& params) {
  ModelsValidity sum;
  std::map<std::string, std::vector<std::string>> format;  // by object, until the object is read
  const auto object = [&](const CityObject& given) {
    ObjectValidity found{given.id, {}, validate_object(given, params)};
    std::vector<std::string> ids = given.parts;
    ids.insert(ids.begin(), given.id);
    for (const std::string& id : ids)
      if (auto node = format.extract(id); !node.empty())
        found.format.insert(found.format.end(), node.mapped().begin(), node.mapped().end());
    ++sum.objects;
    if (found.faults.empty() && found.format.empty()) return;
    ++sum.invalid;
    for (const int code : codes_of(found.faults)) ++sum.codes[code];
    invalid(found);
  };
  const auto fault = [&](const FormatFault& given) {
    ++sum.format_faults;
    given.object.empty() ? invalid({"", {given.text}, {}}) : format[given.object].push_back(given.text);
  };
  try {
    read_solids(path, {object, fault});
  } catch (const Error& broken) {
    if (broken.code() != ExitCode::failed) throw;
    ++sum.codes[901];
    invalid({"", {}, {{901, broken.what()}}});
  }
  for (auto& [id, texts] : format) {
    ++sum.objects, ++sum.invalid;
    invalid({id, std::move(texts), {}});
  }
  return sum;
}

}  // namespace ilot
