// SPDX-License-Identifier: Apache-2.0
// All settings as a list, and settings in and out as text: for a program that takes them from a file, a form or a
// command line. Every fault is an Error with ExitCode::usage that names the place, the range or the nearest key.
// Functions work on the settings that they are given and on nothing else: any thread may call them, two threads not on
// the same Settings at once.
//
//   ilot::Settings settings;
//   ilot::load_config(settings, "office.toml");               // what the file gives
//   ilot::apply_assignment(settings, "planes.epsilon=0.02");  // one value more
//   for (const ilot::Parameter& p : ilot::parameters()) std::puts((p.key + " " + p.unit + ": " + p.help).c_str());
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ilot/settings.h"

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
  bool advanced = false;                             // its default rarely needs a change
};

// In the order in which they are printed: grouped by section, sections in the order of Settings, advanced ones last in
// each.
const std::vector<Parameter>& parameters();

// nullptr when there is none of that name.
const Parameter* find_parameter(std::string_view key);

// As TOML: `"auto"`, `"ransac"`, `true`, `16`, `0.02`, `[7, 18]`. Numbers with the fewest digits that read back to the
// same bits.
std::string to_text(const Value& value);

// What is wrong with the value, as the end of a sentence ("planes.epsilon = 20 is out of range: ..."); nullopt when
// nothing is. An integer is accepted for a number, also in lists, nothing else is converted.
std::optional<std::string> check_value(const Parameter& parameter, const Value& value);

// "0.0001 to 10 m", "ransac, hough"; empty for booleans.
std::string range_text(const Parameter& parameter);

// Overwrites the settings that the TOML file gives and leaves the others. Faults read "FILE:LINE:COLUMN: ...". On a
// fault nothing is changed. Files above 1 MiB are refused.
void load_config(Settings& settings, const std::filesystem::path& path);

// The same on text; `name` stands for the file in messages.
void load_config_text(Settings& settings, std::string_view text, const std::string& name);

// "planes.epsilon=0.02", "classes.noise=[7, 18]", "planes.epsilon=auto". Faults read "--set ASSIGNMENT: ...". On a
// fault nothing is changed.
void apply_assignment(Settings& settings, std::string_view assignment);

// A commented TOML of all settings with default, unit, range and one line of meaning; load_config reads it back to the
// same settings.
std::string print_config(const Settings& settings);

// One JSON object, keys as in the list, `auto` as a string.
std::string settings_json(const Settings& settings);

}  // namespace ilot
