// SPDX-License-Identifier: Apache-2.0
#include "engine/evaluate/validate_models.h"

#include <set>
#include <utility>

#include "engine/deliverables/solid_file.h"
#include "engine/error.h"

namespace ilot {

ModelsValidity validate_models(const std::filesystem::path& path,
                               const std::function<void(const ObjectValidity&)>& invalid,
                               const ValidityParams& params) {
  ModelsValidity sum;
  std::map<std::string, std::vector<std::string>> format;  // by object, until it comes
  const auto object = [&](const CityObject& given) {
    ObjectValidity found{given.id, {}, validate_object(given, params)};
    std::set<std::string> owners{given.id};
    for (const Primitive& p : given.primitives) owners.insert(p.owner);
    for (const std::string& owner : owners)
      if (auto node = format.extract(owner); !node.empty())
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
  for (auto& [id, texts] : format) invalid({id, std::move(texts), {}});
  return sum;
}

}  // namespace ilot
