// SPDX-License-Identifier: Apache-2.0
// What the products say of a point: the extra bytes `label` (docs/outputs.md).
#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace ilot {

enum class PointLabel : std::uint8_t {
  none = 0,
  ground = 1,
  roof = 2,
  wall = 3,
  vegetation = 4,
  facade = 5,  // seen from the street: walls and all that is fixed to them
  window = 6,
  door = 7,
  sill = 8,
  balcony = 9,
  car = 10,
  lamppost = 11,
  pedestrian = 12,
  other = 13,  // stands on the ground and is none of these
};

// Names by value, without `none`: those that truth files use for their classes.
inline const std::map<std::uint32_t, std::string>& point_label_names() {
  static const std::map<std::uint32_t, std::string> names{
      {1, "ground"}, {2, "roof"},    {3, "wall"}, {4, "vegetation"}, {5, "facade"},      {6, "window"}, {7, "door"},
      {8, "sill"},   {9, "balcony"}, {10, "car"}, {11, "lamppost"},  {12, "pedestrian"}, {13, "other"}};
  return names;
}

}  // namespace ilot
