// SPDX-License-Identifier: Apache-2.0
// Points that stand alone: few, and far from everything else. Rays without an echo that were written as 0 0 0, birds,
// echoes over many mirrors, a row of another grid. One of them must not decide what is measured of all others.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "engine/store/coarse_cells.h"

namespace ilot {

// Morton codes of one tile, both ends included.
struct CodeRange {
  std::uint64_t first = 0, last = 0;
};

class Strays {
 public:
  Strays() = default;
  Strays(int bits, std::vector<CoarseCell> cells);  // cells ascending

  const std::vector<CoarseCell>& cells() const { return cells_; }
  bool contains(Index3 p) const;
  std::vector<CodeRange> in_tile(Tile tile) const;  // ascending, disjoint

 private:
  int bits_ = 0;
  std::vector<CoarseCell> cells_;
  std::map<Tile, std::vector<CodeRange>> ranges_;  // where a tile contains the cells, not they it
};

// Cells whose points stand alone. Two cells belong together when the gap between them is at most the edge of a cell on
// each axis: between the boxes of their points where these are few, else the cell itself counts. A group of cells is
// stray when its points are at fewer than kFewPlaces different places (any number of points at one place count once)
// and are at most a tenth of the rest: of the points in cells of many places or, where there is none, of the places of
// the largest group. So a cloud of which all is sparse loses nothing, nor does one of two real parts, however far
// apart. O(cells log cells).
Strays find_strays(const CoarseCells& cells);

}  // namespace ilot
