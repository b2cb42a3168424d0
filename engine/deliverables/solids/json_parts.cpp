// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/json_parts.h"

#include "engine/error.h"
#include "engine/json_fault.h"

namespace ilot {

using Json = nlohmann::json;

const Json& json_field(const Json& object, const char* key) {
  static const Json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

Json parse_json(std::string_view text, const std::string& place) {
  constexpr int kMaxDepth = 64;
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxDepth) throw Error(place + ": values nest too deeply");
    return true;
  };
  try {
    return Json::parse(text.begin(), text.end(), shallow);
  } catch (const Json::exception& fault) {
    throw Error(place + ": broken JSON: " + json_fault(fault.what()));
  }
}

bool is_json_sequence(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != text.npos && text.find('{', end) != text.npos &&
         Json::accept(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace ilot
