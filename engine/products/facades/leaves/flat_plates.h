// SPDX-License-Identifier: Apache-2.0
// Flat plates that lie on a wall: leaves of shutters, but also boards, panels and pilasters.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "engine/products/facades/leaves/relief_cells.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

// A plate and, for each of its sides in the order of kSides, the share of its length beyond which there is wall. Where
// that is small, the plate may go on behind something.
struct FlatPlate {
  FoundRectangle shape;
  std::array<double, 4> wall{};

  // Derived: a majority.
  bool ends_at(Side side) const { return wall[static_cast<std::size_t>(side)] >= 0.5; }
};

// The plates of a wall, and what its rays show about them.
struct FlatPlates {
  std::vector<FlatPlate> plates;
  ReliefCells relief;
};

// Finds rectangles whose points lie at one depth, up to 15 cm before the form of the wall, and through which no rays
// go. What lies less than three standard deviations of the wall before it is the wall; on rough walls the means of
// points about each cell show nearer plates (wall_means.h), whose edges are less sharp. A sill or a lintel ends a plate
// and hides whether it goes on. Strips narrower than 20 cm or three cells are left out. The depth of a plate is that of
// its plane. O(points).
FlatPlates find_flat_plates(const RaySamples& samples);

}  // namespace ilot
