// SPDX-License-Identifier: Apache-2.0
// Reading JSON that may be anything.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ilot {

// A field of an object; null when it is missing or there is no object.
const nlohmann::json& json_field(const nlohmann::json& object, const char* key);

// Error "place: broken JSON: ..." for what is none or nests deeper than any CityJSON does.
nlohmann::json parse_json(std::string_view text, const std::string& place);

// A sequence of JSON texts, one a line, has its second one on a line of its own.
bool is_json_sequence(std::string_view text);

}  // namespace ilot
