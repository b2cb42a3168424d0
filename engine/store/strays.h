// SPDX-License-Identifier: Apache-2.0
// Strays: a few points that are far from all others. Examples are rays without an echo that were written as 0 0 0,
// birds, echoes over many mirrors, a row of another grid. A stray must not influence what is measured of all other
// points.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "engine/store/coarse_cells.h"

namespace ilot {

// A range of Morton codes of one tile, both ends included.
struct CodeRange {
  std::uint64_t first = 0, last = 0;
};

class Strays {
 public:
  Strays() = default;
  Strays(int bits, std::vector<CoarseCell> cells);  // cells ascending

  int bits() const { return bits_; }  // the edge of its cells is 2^bits lattice steps
  const std::vector<CoarseCell>& cells() const { return cells_; }
  bool contains(Index3 p) const;
  std::vector<CodeRange> in_tile(Tile tile) const;  // ascending, disjoint

 private:
  int bits_ = 0;
  std::vector<CoarseCell> cells_;
  std::map<Tile, std::vector<CodeRange>> ranges_;  // when a tile contains the cells; else they contain it
};

// Finds the cells whose points are strays. Two cells belong together when the gap between them is at most the edge of a
// cell on each axis. The gap is between the boxes of their points when these are few, else between the cells. A group
// of cells is stray when its points are at fewer than kFewPlaces different places (any number of points at one place
// count once) and these are at most a tenth of the rest. The rest is the points in cells of many places or, when there
// is none, the places of the largest group. So a cloud that is sparse everywhere loses nothing, and neither does a
// cloud of two real parts at any distance. O(cells log cells).
Strays find_strays(const CoarseCells& cells);

// Returns the least corner of the cells whose points are no strays; the origin where there are none.
Index3 least_corner(const CoarseCells& cells, const Strays& strays);

}  // namespace ilot
