// SPDX-License-Identifier: Apache-2.0
// What a plan must know of points, summed by coarse cells: which of them are strays is known only after all points were
// read, and nothing of a stray may be left in the sums.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "engine/scale/chunk_boxes.h"
#include "engine/scale/survey/point_map.h"
#include "engine/store/coarse_cells.h"
#include "engine/store/lattice_rows.h"
#include "engine/store/strays.h"

namespace ilot {

using InputChunk = std::pair<std::uint32_t, std::size_t>;  // input, and number of the chunk in it

// Sums over some points.
struct PointSums {
  std::uint64_t points = 0;
  std::map<std::uint8_t, std::uint64_t> classes;
  PointMap map;
  std::map<InputChunk, IndexBox> chunks;

  explicit PointSums(int bits) : map(bits) {}
  void add(const PointSums& other);
  IndexBox box() const;  // of all points
};

class PointSummary {
 public:
  // `step_metres` is a step of the lattice.
  explicit PointSummary(double step_metres);

  // Adds points of one input. Memory: 64 bytes a square, kMostSquares at most, and 80 for each chunk, in each coarse
  // cell of few places. Throws Error where such cells lie in more tiles than a store may have.
  void add(std::span<const LatticePoint> points, std::uint32_t input, const ChunkBoxes& chunks);
  // The result does not depend on the order in which parts are added.
  void add(const PointSummary& part);

  const CoarseCells& cells() const { return cells_; }
  std::size_t tiles() const { return tiles_.size(); }  // of a store that has all points, strays too

  // The sums without the strays, and how many points these are. To be called when all is added.
  std::pair<PointSums, std::uint64_t> without(const Strays& strays) &&;

 private:
  bool is_many(CoarseCell cell) const;
  PointSums& apart_at(CoarseCell cell);
  void settle();

  int cell_bits_, square_bits_;
  CoarseCells cells_;
  PointSums settled_;                      // of cells that have too many places to be strays
  std::map<CoarseCell, PointSums> apart_;  // of all others
  std::set<Tile> tiles_, tiles_apart_;     // of all cells, and of those of apart_
};

}  // namespace ilot
