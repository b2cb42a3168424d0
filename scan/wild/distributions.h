// SPDX-License-Identifier: Apache-2.0
// What the wild scenes draw: one file of distributions (distributions.csv) that is part of the program.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scan/scene_options.h"

namespace ilot::scan {

enum class DistributionKind : std::uint8_t {
  uniform,      // between `from` and `to`
  log_uniform,  // its logarithm is uniform
  normal,       // mean in the middle, standard deviation a quarter of the range, cut at both ends
  whole,        // a whole number from `from` to `to`, both included
  mixed,        // 0, `to`, or uniform between `from` and `to`, with the weights none, all and some
  choice        // one of the names, with their weights
};

struct Distribution {
  std::string_view name, unit;
  DistributionKind kind = DistributionKind::uniform;
  double from = 0, to = 0;  // of a choice: the first and the last index
  std::vector<std::string_view> choices;
  std::vector<double> weights;  // of the choices, or of none, some and all; their sum is 1
  std::string_view per;         // "scene", or the kind of element for which it is drawn again
  std::string_view group;       // the scenes that use it name its group
  std::string_view family;      // the family of forms that it belongs to; empty = always there
  std::string_view meaning, source;
};

// Returns the rows of the file in its order. Throws Error where the file is faulty.
std::span<const Distribution> distributions();

// Parses a file of that form. The text must outlive the result. Throws Error that names the line.
std::vector<Distribution> parse_distributions(std::string_view text);

// Returns the SHA-256 of the file as 64 digits.
const std::string& distributions_hash();

// Returns the options of a scene that draws from these groups: "scene.NAME" for each row, in the order of the file.
// The result lives as long as the program.
std::span<const SceneOption> drawn_options(std::span<const std::string_view> groups);

// Returns the families of forms of these groups, each once, in the order of the file.
std::vector<std::string_view> families_of(std::span<const std::string_view> groups);

}  // namespace ilot::scan
