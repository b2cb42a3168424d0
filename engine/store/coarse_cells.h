// SPDX-License-Identifier: Apache-2.0
// Finds the coarse cubes of space that contain points and counts the points exactly, in bounded memory. Strays are
// found from this (strays.h).
#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "engine/store/lattice.h"
#include "kernels/core/radix_sort.h"

namespace ilot {

// A cube of 2^bits lattice units. Its faces are at fixed multiples of its edge.
struct CoarseCell {
  std::int64_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const CoarseCell&, const CoarseCell&) = default;
};
constexpr CoarseCell coarse_cell(Index3 p, int bits) {
  return {p.x >> bits, p.y >> bits, p.z >> bits};
}

// A cell with points at fewer different places than this has few places: fewer than the smallest surface or object that
// any product keeps.
constexpr std::size_t kFewPlaces = 100;

struct CellContent {
  std::uint64_t points = 0;
  std::vector<Index3> places;  // sorted, each once; empty when they are many
  bool many = false;           // kFewPlaces different places or more
};

// Counts of points by cell. When more than kMostCoarseCells cells are occupied, cells of twice the edge are counted
// instead. So memory stays below 20 MB for points of any extent. The result depends only on the points, not on their
// order or on the parts in which they were counted and merged.
constexpr std::size_t kMostCoarseCells = 1 << 13;

class CoarseCells {
 public:
  explicit CoarseCells(int bits) : bits_(bits) {}

  void add(Index3 p);
  void add(Tile tile, std::span<const KeyValue> points);  // of one tile, sorted by code; mostly O(cells log(points))
  void merge(CoarseCells other);

  int bits() const { return bits_; }
  std::int64_t edge() const { return std::int64_t{1} << bits_; }
  const std::map<CoarseCell, CellContent>& cells() const { return cells_; }

  // Converts the cells to integers for a file, and back.
  std::vector<std::int64_t> packed() const;
  static CoarseCells unpacked(std::span<const std::int64_t> packed);

 private:
  CellContent& at(CoarseCell cell);
  void coarsen_to(int bits);
  void shrink();

  int bits_;
  std::map<CoarseCell, CellContent> cells_;
  CoarseCell last_cell_;
  CellContent* last_ = nullptr;  // content of last_cell_: neighbours in a file are mostly in the same cell
};

// Edge of the cells before any doubling: the greatest power of two of units that does not exceed kCoarseMetres.
constexpr double kCoarseMetres = 600;
int coarse_bits(double unit_metres);

}  // namespace ilot
