// SPDX-License-Identifier: Apache-2.0
#include "scan/scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/error.h"
#include "engine/settings/nearest_name.h"

namespace ilot::scan {
namespace {

constexpr std::array<SceneOption, 11> kDistrict{{
    {"scene.area_km2", 0.05, "km2", 0.0001, 10000, "area of the square; --points chooses it where it is not set"},
    {"scene.density", 12, "pulses/m2", 0.1, 200, "pulses per area, all flight lines together"},
    {"scene.noise", 0.02, "m", 0, 1, "standard deviation of the range"},
    {"scene.jitter", 0.2, "spacings", 0, 0.5, "largest shift of a pulse's aim"},
    {"scene.height", 500, "m", 100, 5000, "flying height above the ground"},
    {"scene.scan_angle", 20, "deg", 5, 30, "largest scan angle to either side"},
    {"scene.slope", 2, "%", 0, 10, "slope of the ground"},
    {"scene.trees", 15, "per ha", 0, 60, "trees"},
    {"scene.adjoining", 0.4, "share", 0, 1, "groups of houses that adjoin, at different heights"},
    {"scene.flat", 0.25, "share", 0, 1, "houses with a flat roof"},
    {"scene.hip", 0.25, "share", 0, 1, "houses with a hip roof; those neither flat nor hip have a gable"},
}};

// Returns the number of a name in "first|second|third".
std::optional<double> choice_value(std::string_view choices, std::string_view name) {
  for (double index = 0; !choices.empty(); ++index) {
    const std::size_t end = std::min(choices.find('|'), choices.size());
    if (choices.substr(0, end) == name) return index;
    choices.remove_prefix(std::min(end + 1, choices.size()));
  }
  return std::nullopt;
}

}  // namespace

std::span<const SceneOption> district_options() {
  return kDistrict;
}

void SceneValues::set(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw Error(fmt::format("--set {}: write it as scene.key=value", assignment), ExitCode::usage);
  const std::string_view key = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  const auto option = std::find_if(options_.begin(), options_.end(), [&](const auto& o) { return o.key == key; });
  if (option == options_.end()) {
    std::vector<std::string> keys;
    for (const SceneOption& o : options_) keys.emplace_back(o.key);
    throw Error(fmt::format("--set {}: no such key{}", key, did_you_mean(key, keys)), ExitCode::usage);
  }
  if (const auto chosen = choice_value(option->choices, text)) {
    values_.insert_or_assign(std::string(key), *chosen);
    return;
  }
  if (!option->choices.empty())
    throw Error(fmt::format("--set {}: \"{}\" is not one of {}", key, text, option->choices), ExitCode::usage);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= option->low && value <= option->high))
    throw Error(fmt::format("--set {}: \"{}\" is not a number from {} to {} ({})", key, text, option->low, option->high,
                            option->unit),
                ExitCode::usage);
  values_.insert_or_assign(std::string(key), value);
}

void SceneValues::leave_out(std::string_view families, std::span<const std::string_view> known) {
  while (!families.empty()) {
    const std::size_t end = std::min(families.find(','), families.size());
    const std::string_view family = families.substr(0, end);
    families.remove_prefix(std::min(end + 1, families.size()));
    if (std::find(known.begin(), known.end(), family) == known.end()) {
      std::string names;
      for (std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
      throw Error(fmt::format("--without {}: {}", family,
                              names.empty() ? "this scene has no families of forms" : "not one of " + names),
                  ExitCode::usage);
    }
    left_out_.emplace(family);
  }
}

bool SceneValues::leaves_out(std::string_view family) const {
  return left_out_.find(family) != left_out_.end();
}

double SceneValues::get(std::string_view key) const {
  if (const auto found = values_.find(key); found != values_.end()) return found->second;
  const auto option = std::find_if(options_.begin(), options_.end(), [&](const auto& o) { return o.key == key; });
  if (option == options_.end()) throw Error(fmt::format("{} is not an option of this scene", key));
  return option->standard;
}

std::string SceneValues::json() const {
  std::string text;
  for (const SceneOption& option : options_)
    if (!option.drawn || is_set(option.key))
      text += fmt::format(",\"{}\":{}", option.key.substr(option.key.find('.') + 1), get(option.key));
  std::string families;
  for (const std::string& family : left_out_) families += (families.empty() ? "\"" : ",\"") + family + "\"";
  if (!families.empty()) text += ",\"without\":[" + families + "]";
  return text;
}

bool SceneValues::is_set(std::string_view key) const {
  return values_.find(key) != values_.end();
}

}  // namespace ilot::scan
