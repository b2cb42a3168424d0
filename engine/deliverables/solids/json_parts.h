// SPDX-License-Identifier: Apache-2.0
// Functions that read JSON of any content.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ilot {

// Returns a field of an object; null when the field is missing or `object` is not an object.
const nlohmann::json& json_field(const nlohmann::json& object, const char* key);

// Throws Error "place: broken JSON: ..." for text that is not JSON or nests deeper than any CityJSON does.
nlohmann::json parse_json(std::string_view text, const std::string& place);

// A file is a sequence of JSON texts, one a line, when its second text begins on a new line.
bool is_json_sequence(std::string_view text);

}  // namespace ilot
