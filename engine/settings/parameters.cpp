// SPDX-License-Identifier: Apache-2.0
#include "engine/settings/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/settings/nearest_name.h"

namespace ilot {
namespace {

std::string number_text(double number) {
  char buffer[32];
  if (!std::isfinite(number)) return std::isnan(number) ? "nan" : (number < 0 ? "-inf" : "inf");
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  std::string text(buffer, end);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return whole ? text + ".0" : text;
}

// Returns the end of a range as a text for people, without an exponent and without ".0".
std::string bound_text(double bound) {
  char buffer[400];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, bound, std::chars_format::fixed).ptr};
}

bool fits_kind(const Parameter& p, const Value& value) {
  switch (p.kind) {
    case ParameterKind::boolean:
      return std::holds_alternative<bool>(value);
    case ParameterKind::integer:
      return std::holds_alternative<std::int64_t>(value);
    case ParameterKind::number:
      return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
    case ParameterKind::integers:
      return std::holds_alternative<std::vector<std::int64_t>>(value);
    case ParameterKind::numbers:
      return std::holds_alternative<std::vector<double>>(value) ||
             std::holds_alternative<std::vector<std::int64_t>>(value);
    case ParameterKind::choice:
      return std::holds_alternative<std::string>(value) &&
             std::find(p.choices.begin(), p.choices.end(), std::get<std::string>(value)) != p.choices.end();
  }
  return false;
}

bool in_range(const ValueRange& range, const Value& value) {
  const auto inside = [&](double v) { return v >= range.min && v <= range.max; };
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return inside(static_cast<double>(*whole));
  if (const auto* number = std::get_if<double>(&value)) return inside(*number);
  if (const auto* list = std::get_if<std::vector<std::int64_t>>(&value)) {
    return std::all_of(list->begin(), list->end(), [&](std::int64_t v) { return inside(static_cast<double>(v)); });
  }
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    return std::all_of(list->begin(), list->end(), inside);
  return true;
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> table = parameter_table();
  return table;
}

const Parameter* find_parameter(std::string_view key) {
  for (const Parameter& p : parameters()) {
    if (p.key == key) return &p;
  }
  return nullptr;
}

std::string did_you_mean_parameter(std::string_view key) {
  const bool dotted = key.find('.') != std::string_view::npos;
  std::vector<std::string> names, keys;
  for (const Parameter& p : parameters()) {
    names.push_back(dotted ? p.key : p.key.substr(p.key.rfind('.') + 1));
    keys.push_back(p.key);
  }
  const auto name = nearest_name(key, names);
  if (!name) return "; ilot run --print-config lists all settings";
  std::string text;  // two sections may have a setting of the same name
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == *name) text += (text.empty() ? "; did you mean '" : "' or '") + keys[i];
  return text + "'?";
}

std::optional<std::string> check_value(const Parameter& p, const Value& value) {
  if (std::holds_alternative<Auto>(value)) {
    if (p.optional) return std::nullopt;
    return p.key + " cannot be \"auto\": it must be " + expected_text(p);
  }
  if (!fits_kind(p, value)) return p.key + " must be " + expected_text(p) + ", not " + to_text(value);
  if (p.kind != ParameterKind::boolean && !in_range(p.range, value)) {
    return p.key + " = " + to_text(value) + " is out of range: " + range_text(p);
  }
  return std::nullopt;
}

std::string expected_text(const Parameter& p) {
  const char* names[] = {"true or false",           "a whole number",    "a number",
                         "a list of whole numbers", "a list of numbers", "one of "};
  std::string text = names[static_cast<int>(p.kind)];
  if (p.kind == ParameterKind::choice) text += range_text(p);
  if (!p.unit.empty()) text += " (" + p.unit + ")";
  return p.optional ? text + " or \"auto\"" : text;
}

std::string to_text(const Value& value) {
  if (std::holds_alternative<Auto>(value)) return "\"auto\"";
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* name = std::get_if<std::string>(&value)) return '"' + *name + '"';
  std::string text;
  const auto add = [&](const std::string& entry) { text += (text.empty() ? "" : ", ") + entry; };
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    for (const double entry : *numbers) add(number_text(entry));
  } else {
    for (const std::int64_t entry : std::get<std::vector<std::int64_t>>(value)) add(std::to_string(entry));
  }
  return "[" + text + "]";
}

std::string range_text(const Parameter& p) {
  if (p.kind == ParameterKind::boolean) return "";
  if (p.kind == ParameterKind::choice) {
    std::string names;
    for (const std::string_view name : p.choices) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
  }
  const std::string unit = p.unit.empty() ? "" : " " + p.unit;
  return bound_text(p.range.min) + " to " + bound_text(p.range.max) + unit;
}

}  // namespace ilot
