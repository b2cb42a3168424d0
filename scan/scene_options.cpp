// SPDX-License-Identifier: Apache-2.0
#include "scan/scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/error.h"

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

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
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
    const auto nearest = std::min_element(options_.begin(), options_.end(), [&](const auto& a, const auto& b) {
      return edit_distance(a.key, key) < edit_distance(b.key, key);
    });
    throw Error(fmt::format("--set {}: no such key; the nearest is {}", key, nearest->key), ExitCode::usage);
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= option->low && value <= option->high))
    throw Error(fmt::format("--set {}: \"{}\" is not a number from {} to {} ({})", key, text, option->low, option->high,
                            option->unit),
                ExitCode::usage);
  values_.insert_or_assign(std::string(key), value);
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
    text += fmt::format(",\"{}\":{}", option.key.substr(option.key.find('.') + 1), get(option.key));
  return text;
}

bool SceneValues::is_set(std::string_view key) const {
  return values_.find(key) != values_.end();
}

}  // namespace ilot::scan
