// SPDX-License-Identifier: Apache-2.0
// First half of the index: each stretch of the inputs becomes a file of points sorted by key. No result shows in which
// stretch a point was, because blocks merge the points of an octree node from all runs.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "engine/store/coarse_cells.h"
#include "engine/store/lattice.h"
#include "engine/store/lattice_rows.h"
#include "engine/store/store.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// The points of one tile in a run: positions [first, end) of the run's columns.
struct RunTile {
  Tile tile;
  std::uint64_t first = 0, end = 0;
};

constexpr std::uint64_t kRunSample = 1024;  // every 1,024th code of the run is kept in memory

// Each tile needs a block, which is about 15 files, however few points it contains. So points in more tiles than this
// are refused: 36,000 km2 at a millimetre, 3.6 km2 at 0.01 mm. With the nodes of more than block_points points, each
// split into at most 8, a store has at most kMostTiles + 147 points / block_points blocks: a split adds 7, and on each
// of the 21 levels at most points / block_points nodes are split. Points that are distributed as in a city need about 3
// points / block_points.
constexpr std::size_t kMostTiles = 1 << 13;
void refuse_many_tiles(std::size_t tiles);

struct SortedRun {
  std::filesystem::path stem;  // stem.points has KeyValue of code and RunValue; stem.table is written last
  std::array<std::uint64_t, kRejections> rejected{};
  std::vector<RunTile> tiles;          // ascending
  std::vector<std::uint64_t> samples;  // code at position i * kRunSample
  std::vector<Index3> off_lattice;     // in the finest steps of the inputs: places that are not a multiple, each once
};

// The data of a point that a run keeps beside its code, so that sorting moves it too: the input order in the upper 54
// bits, then 8 bits of class and 2 of echoes.
using RunValue = std::uint64_t;
constexpr RunValue run_value(InputOrder order, std::uint8_t classification, std::uint8_t echoes) {
  return (file_of(order) << kRunRowBits | row_of(order)) << 10 | std::uint64_t{classification} << 2 | echoes;
}
constexpr InputOrder order_of(RunValue value) {
  return input_order(value >> (kRunRowBits + 10), value >> 10 & (kMostRowsOfInput - 1));
}
constexpr std::uint8_t class_of(RunValue value) {
  return static_cast<std::uint8_t>(value >> 2);
}
constexpr std::uint8_t echoes_of(RunValue value) {
  return value & 3;
}

// Writes the points of a run, which come in their order.
class SortedRunWriter {
 public:
  explicit SortedRunWriter(const std::filesystem::path& stem);
  // Points of one tile, ascending by code. Tiles ascend; the points of a tile may come in several calls.
  void add(Tile tile, std::span<const KeyValue> points);
  // Completes stem.points. The table is not written: the run is known to the caller alone.
  SortedRun finish();

 private:
  SortedRun run_;
  ColumnWriter<KeyValue> file_;
  std::uint64_t written_ = 0;
};

// Reads rows and writes stem.*; 64 bytes of memory a row. `read_rows` is called with the number of rows that were read.
// The coarse cells include points outside the area, because whether a point is a stray does not depend on the area.
SortedRun make_sorted_run(const RowSource& source, const InputLattice& lattice, const IndexFilter& filter,
                          const std::filesystem::path& stem, const std::function<void(std::uint64_t)>& read_rows);

// Returns the table of a run that an earlier start finished; nullopt when there is none.
std::optional<SortedRun> find_sorted_run(const std::filesystem::path& stem);

// Returns the coarse cells with the points of a run that was made with coarse_bits.
CoarseCells coarse_cells_of(const SortedRun& run);

// Returns stem.points and the related files.
inline std::filesystem::path with_suffix(std::filesystem::path stem, const char* suffix) {
  return stem += suffix;
}

}  // namespace ilot
