// SPDX-License-Identifier: Apache-2.0
// The options of a scene. Each key is declared once, with its default, unit, range and meaning.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace ilot::scan {

struct SceneOption {
  std::string_view key;  // "scene.density"
  double standard;
  std::string_view unit;
  double low, high;  // both ends are allowed
  std::string_view help;
  bool drawn = false;             // unless it is set, the seed decides; `standard` is not used
  std::string_view choices = {};  // names of the values 0, 1, 2... with | between them; empty = a number
};

// Puts the options that all terrestrial scenes share before the scene's own options.
template <std::size_t N>
constexpr std::array<SceneOption, N + 6> with_beam_options(const std::array<SceneOption, N>& own) {
  std::array<SceneOption, N + 6> all{{
      {"scene.noise", 0.002, "m", 0, 0.1, "standard deviation of the range"},
      {"scene.angle_noise", 0.0015, "deg", 0, 0.1, "standard deviation of the beam's direction about each axis"},
      {"scene.divergence", 0.2, "mrad", 0, 5, "full angle of the beam"},
      {"scene.diameter", 0.0045, "m", 0, 0.05, "of the beam at the scanner"},
      {"scene.registration", 0, "m", 0, 0.1, "standard deviation of each station's place along each axis"},
      {"scene.separation", 0.3, "m", 0, 5, "echoes closer than that mix into one"},
  }};
  for (std::size_t i = 0; i < N; ++i) all[6 + i] = own[i];
  return all;
}

// Returns the options of the scene `district`.
std::span<const SceneOption> district_options();

class SceneValues {
 public:
  explicit SceneValues(std::span<const SceneOption> options) : options_(options) {}

  // Takes "scene.key=value". Throws Error (usage) for an unknown key and names the nearest known key. Throws Error
  // (usage) too when the value is neither a number within the range nor one of the choices.
  void set(std::string_view assignment);

  // Leaves out families of forms: names with commas between them. Throws Error (usage) for a name that is not one of
  // `known`.
  void leave_out(std::string_view families, std::span<const std::string_view> known);
  bool leaves_out(std::string_view family) const;

  double get(std::string_view key) const;  // the default if nothing was set; the key must exist
  bool is_set(std::string_view key) const;

  // Returns the values as members of a JSON object, without those that the seed decides, and the families that are left
  // out. Each member has a comma before it: ,"density":12
  std::string json() const;

 private:
  std::span<const SceneOption> options_;
  std::map<std::string, double, std::less<>> values_;
  std::set<std::string, std::less<>> left_out_;
};

}  // namespace ilot::scan
