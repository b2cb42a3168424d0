// SPDX-License-Identifier: Apache-2.0
// What lies before a wall in cells, and where plates end: at the wall, or at a pier between two of them.
#pragma once
#include <vector>

#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/sides/located_edge.h"

namespace ilot {

// Choice: the width of a narrow pier.
inline constexpr double kAboutPlate = 0.3;  // metres about a plate that are looked at for its sides and the wall

// Choice: half of a narrow window; narrower leaves cannot be distinguished from surrounds and pipes.
inline constexpr double kNarrowestPlate = 0.2;  // metres

// Choice: louvres and fittings of a leaf stand out less, sills more.
inline constexpr double kBeforePlate = 0.04;  // metres before a plate from which on something is not a part of it

// The wall in cells, with the mean distance from the form of what lies before it.
struct ReliefCells {
  WallCells cells;
  std::vector<float> out;
};

// The cells of narrow piers: what lies before the wall there lies deeper, by more than `apart` metres, than plates that
// begin within 30 cm on both sides on the same row, and so do most cells up to 30 cm above and below: plants and
// fittings before a leaf make single cells of it deeper than others. Surrounds of two windows on a narrow pier and
// mixed cells are no wall, so that leaves on both sides of it would be one plate. O(cells).
std::vector<bool> pier_cells(const ReliefCells& relief, double apart);

// The share of the lines across a side of a plate in a box, `out` metres before the wall, that meet the wall beyond it,
// or a pier on its left or right. What was not seen over more than a few centimetres above or below may belong to the
// plate, and so may what something farther before the wall hides: a sill, a lintel.
double wall_beyond(const ReliefCells& relief, const std::vector<bool>& is_pier, const CellBox& box, double out,
                   Side side);

// The share of the cells of a box in which something stands before the wall. O(cells).
double relief_share(const ReliefCells& relief, const Box2& box);

}  // namespace ilot
