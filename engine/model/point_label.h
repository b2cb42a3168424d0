// SPDX-License-Identifier: Apache-2.0
// The labels that the products give to a point: the extra bytes `label` (docs/outputs.md).
#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "ilot/cloud_info.h"

namespace ilot {

// The names by value, without `none`. Truth files use these names for their classes.
inline const std::map<std::uint32_t, std::string>& point_label_names() {
  static const std::map<std::uint32_t, std::string> names{
      {1, "ground"}, {2, "roof"},    {3, "wall"}, {4, "vegetation"}, {5, "facade"},      {6, "window"}, {7, "door"},
      {8, "sill"},   {9, "balcony"}, {10, "car"}, {11, "lamppost"},  {12, "pedestrian"}, {13, "other"}};
  return names;
}

// True for the classes of objects that stand on a street: all labels from `car` on. A new class is the last one, with a
// name above.
inline bool is_street_object(PointLabel label) {
  return label >= PointLabel::car && point_label_names().contains(static_cast<std::uint32_t>(label));
}

}  // namespace ilot
