// SPDX-License-Identifier: Apache-2.0
// What can be set about a scene: each key declared once with its default, unit, range and meaning.
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace ilot::scan {

struct SceneOption {
  std::string_view key;  // "scene.density"
  double standard;
  std::string_view unit;
  double low, high;  // both allowed
  std::string_view help;
};

// Options of the scene `district`.
std::span<const SceneOption> district_options();

class SceneValues {
 public:
  explicit SceneValues(std::span<const SceneOption> options) : options_(options) {}

  // Takes "scene.key=value". Throws Error (usage) for an unknown key, naming the nearest, and for what is not
  // a number within the range.
  void set(std::string_view assignment);

  double get(std::string_view key) const;  // the default where nothing was set; the key must exist
  bool is_set(std::string_view key) const;

 private:
  std::span<const SceneOption> options_;
  std::map<std::string, double, std::less<>> values_;
};

}  // namespace ilot::scan
