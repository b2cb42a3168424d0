// SPDX-License-Identifier: Apache-2.0
// The labels that the products give to a point: the extra bytes `label` (docs/outputs.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ilot/cloud_info.h"

namespace ilot {

// The names by value, without `none`. Truth files use these names for their classes.
inline const std::map<std::uint32_t, std::string>& point_label_names() {
  static const std::map<std::uint32_t, std::string> names{
      {1, "ground"}, {2, "roof"},     {3, "wall"},         {4, "vegetation"}, {5, "facade"},    {6, "window"},
      {7, "door"},   {8, "sill"},     {9, "balcony"},      {10, "car"},       {11, "lamppost"}, {12, "pedestrian"},
      {13, "other"}, {14, "van"},     {15, "two_wheeler"}, {16, "sign"},      {17, "bollard"},  {18, "bin"},
      {19, "bench"}, {20, "planter"}, {21, "fence"},       {22, "cabinet"}};
  return names;
}

// The label of a name above; nullopt for any other.
inline std::optional<PointLabel> label_named(std::string_view name) {
  for (const auto& [value, known] : point_label_names())
    if (known == name) return static_cast<PointLabel>(value);
  return std::nullopt;
}

// The labels from here on are classes of objects that a training brought along (--train), in the order of their names.
constexpr std::uint32_t kFirstOwnLabel = 100;
constexpr std::size_t kMostOwnClasses = 256 - kFirstOwnLabel;
using OwnClasses = std::vector<std::string>;  // ascending; the label of own[i] is kFirstOwnLabel + i

inline bool is_own_class(PointLabel label) {
  return static_cast<std::uint32_t>(label) >= kFirstOwnLabel;
}
inline PointLabel own_class(std::size_t i) {
  return static_cast<PointLabel>(kFirstOwnLabel + i);
}

// The name of any label. "own N" where `own` does not know it.
inline std::string class_name_of(PointLabel label, const OwnClasses& own) {
  const auto value = static_cast<std::uint32_t>(label);
  if (label == PointLabel::none) return "none";
  if (!is_own_class(label)) return point_label_names().at(value);
  return value - kFirstOwnLabel < own.size() ? own[value - kFirstOwnLabel] : "own " + std::to_string(value);
}

// True for the classes of objects that stand on a street: all labels from `car` on. A new class is the last one, with a
// name above.
inline bool is_street_object(PointLabel label) {
  return label >= PointLabel::car &&
         (is_own_class(label) || point_label_names().contains(static_cast<std::uint32_t>(label)));
}

// The four classes of Hernandez and Marcotegui (2008): car, lamppost, pedestrian, and other for all other objects. A
// van is a car there.
inline PointLabel group_of(PointLabel label) {
  if (label == PointLabel::van) return PointLabel::car;
  return label > PointLabel::other && is_street_object(label) ? PointLabel::other : label;
}

}  // namespace ilot
