// SPDX-License-Identifier: Apache-2.0
#include "engine/settings/nearest_name.h"

#include <algorithm>
#include <vector>

namespace ilot {
namespace {

constexpr std::size_t kLongest = 200;       // Choice: letters that are compared; names are shorter, other text is cut.
constexpr std::size_t kLeastBeginning = 3;  // Choice: letters; fewer of them begin too many names.
constexpr std::size_t kAlwaysNear = 2;      // Choice: letters; one slip of the fingers, or two.

std::size_t distance_to(std::string_view typed, std::string_view name) {
  if (typed.size() >= kLeastBeginning && name.size() > typed.size() && name.starts_with(typed)) return 1;
  return edit_distance(typed, name);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = above[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

std::optional<std::string> nearest_name(std::string_view typed, std::span<const std::string> names) {
  typed = typed.substr(0, kLongest);
  const std::string* best = nullptr;
  std::size_t least = 0;
  for (const std::string& name : names) {
    const std::size_t distance = distance_to(typed, name);
    if (best == nullptr || distance < least) best = &name, least = distance;
  }
  if (best == nullptr || least >= typed.size()) return std::nullopt;
  if (least > std::max(kAlwaysNear, std::max(typed.size(), best->size()) / 3)) return std::nullopt;
  return *best;
}

std::string did_you_mean(std::string_view typed, std::span<const std::string> names) {
  const auto name = nearest_name(typed, names);
  return name ? "; did you mean '" + *name + "'?" : "";
}

}  // namespace ilot
