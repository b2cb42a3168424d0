// SPDX-License-Identifier: Apache-2.0
// What is known of buildings and crowns at a pixel: what stands in its cell, and how far the next building is.
#pragma once
#include <algorithm>
#include <cmath>

#include "engine/products/streets/ground/cells.h"
#include "engine/products/streets/ground/standing_form.h"

namespace ilot {

// A value of the layer "beside".
class StructuresBeside {
 public:
  explicit StructuresBeside(Height value) : value_(value == kNoHeight ? 0 : value) {}
  StructuresBeside(Structure structure, double metres)
      : value_(static_cast<Height>(structure) + kStructures * static_cast<Height>(std::llround(metres / kUnit))) {}

  Height value() const { return value_; }
  Structure structure() const { return static_cast<Structure>(value_ % kStructures); }
  double distance() const { return value_ / kStructures * kUnit; }  // metres to a cell of a building

 private:
  static constexpr Height kStructures = 8;
  static constexpr double kUnit = 0.01;  // metres
  Height value_;
};

// Choice: the width of a pavement beside a house; what is farther from it is free of it.
constexpr double kBesideReach = 2;  // metres; farther buildings are not sought

// The values of the cells of a tile. Reads the layer "structure" of cells. A building is a wall or a roof; distances
// are those of the middles of cells, at most kBesideReach.
Image structures_beside(const Cells& cells, std::size_t tile);

}  // namespace ilot
