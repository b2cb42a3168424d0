// SPDX-License-Identifier: Apache-2.0
// Cuts a map into sheets of one size and one round scale.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/deliverables/maps/street_shapes.h"

namespace ilot {

// The least number of 1, 2 or 5 times a power of ten that is not below the value, and the greatest that is not above.
double round_up(double value);
double round_down(double value);

struct MapSheet {
  std::int64_t column = 0, row = 0;
};

struct SheetGrid {
  double scale = 1;              // 1 : scale
  FlatPoint corner;              // metres on the map; of column 0 and row 0
  FlatPoint size;                // metres on the ground; of a sheet
  std::vector<MapSheet> sheets;  // from the north row by row, in a row from the west

  FlatBox ground(std::size_t sheet) const;
  // The number, from 1, of the sheet that is so many columns and rows away; 0: there is none.
  std::size_t number_beside(std::size_t sheet, std::int64_t columns, std::int64_t rows) const;
};

// The sheets that a line, a border of an area or a circle reaches, at the largest scale of 1 : 250, 500, 1000, 2000 ...
// at which there are 40 or fewer. A map without anything has one sheet. `frame_mm`: what a sheet shows on paper.
// O(vertices + sheets) for each scale that is tried.
SheetGrid sheets_of(const StreetShapes& map, FlatPoint frame_mm);

}  // namespace ilot
