// SPDX-License-Identifier: Apache-2.0
// The one table of settings: what the configuration file, --set, --print-config, docs/parameters.md and
// run.json know of a setting comes from here.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/settings/settings.h"

namespace ilot {

// Written `auto`: the engine chooses from the data and says what it chose.
struct Auto {
  friend bool operator==(Auto, Auto) = default;
};

using Value =
    std::variant<Auto, bool, std::int64_t, double, std::vector<std::int64_t>, std::vector<double>, std::string>;

enum class ParameterKind { boolean, integer, number, integers, numbers, choice };

// Closed. Integers in it are exact up to 2^53.
struct ValueRange {
  double min = 0, max = 0;
};

struct Parameter {
  std::string key;  // "planes.epsilon"
  ParameterKind kind;
  bool optional;                              // `auto` is a value
  ValueRange range;                           // of each entry of a list; of no meaning for booleans and choices
  std::span<const std::string_view> choices;  // of a choice
  std::string unit;                           // "m", "deg" or empty
  std::string help;                           // one line
  std::function<Value(const Settings&)> get;
  std::function<void(Settings&, const Value&)> set;  // expects a value that check_value() accepts
};

// In the order in which they are printed: grouped by section, sections in the order of Settings.
const std::vector<Parameter>& parameters();

// nullptr when there is none of that name.
const Parameter* find_parameter(std::string_view key);

// The key with the smallest edit distance (insert, delete, replace, swap of neighbours), ties to the earlier
// one.
const Parameter& nearest_parameter(std::string_view key);

// What is wrong with the value, as the end of a sentence ("planes.epsilon = 20 is out of range: ...");
// nullopt when nothing is. An integer is accepted for a number, also in lists, nothing else is converted.
std::optional<std::string> check_value(const Parameter& parameter, const Value& value);

// What the parameter takes: "a number (m) or \"auto\"".
std::string expected_text(const Parameter& parameter);

// As TOML: `"auto"`, `"ransac"`, `true`, `16`, `0.02`, `[7, 18]`. Numbers with the fewest digits that read back to the
// same bits.
std::string to_text(const Value& value);

// "0.0001 to 10 m", "ransac, hough"; empty for booleans.
std::string range_text(const Parameter& parameter);

}  // namespace ilot
