// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/store/box_tree.h"
#include "engine/store/column_file.h"
#include "engine/store/columns.h"
#include "engine/store/lattice.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// A leaf of the partition: the points of one octree node, sorted by code; ties are in input order.
struct Block {
  Node node;
  std::uint32_t points = 0;
  IndexBox box;  // of its points, tight
};

// Blocks on disk: one immutable file for each block and column. No result shows which points are in which block; the
// global order of points (tile, code) is the same for any blocks. Columns: engine/store/columns.h.
class Store {
 public:
  Store(std::filesystem::path folder, double unit, std::vector<Block> blocks);

  const std::filesystem::path& folder() const { return folder_; }
  double unit() const { return unit_; }  // CRS units per lattice step
  const std::vector<Block>& blocks() const { return blocks_; }
  std::uint64_t points() const { return points_; }
  IndexBox box() const;  // of all points; empty without a point

  // Returns the blocks whose points may be in the box, in global order. O(answer * log blocks).
  std::vector<std::uint32_t> blocks_in(const IndexBox& box) const;

  template <class T>
  bool has(std::uint32_t block, const Column<T>& column) const {
    return std::filesystem::exists(path(block, column));
  }
  template <class T>
  std::filesystem::path path(std::uint32_t block, const Column<T>& column) const {
    return file(block, column.info.name);
  }

  template <class T>
  void write(std::uint32_t block, const Column<T>& column, std::span<const T> values) const {
    write_column<T>(path(block, column), values);
  }
  template <class T>
  void write(std::uint32_t block, const Column<T>& column, const std::vector<T>& values) const {
    write_column<T>(path(block, column), values);
  }
  template <class T>
  ColumnReader<T> open(std::uint32_t block, const Column<T>& column) const {
    return ColumnReader<T>(path(block, column));
  }
  template <class T>
  std::vector<T> read(std::uint32_t block, const Column<T>& column, std::uint64_t first, std::uint64_t count) const {
    std::vector<T> values(count);
    open(block, column).read(first, values);
    return values;
  }
  // Returns all values: those of the block's points, or as many as were written.
  template <class T>
  std::vector<T> read(std::uint32_t block, const Column<T>& column) const {
    return read_column<T>(path(block, column));
  }

 private:
  std::filesystem::path file(std::uint32_t block, const char* column) const;

  std::filesystem::path folder_;
  double unit_;
  std::vector<Block> blocks_;
  std::vector<IndexBox> boxes_;  // of the blocks
  BoxTree tree_;                 // over these
  std::uint64_t points_ = 0;
};

constexpr std::uint32_t kChunkPoints = 1024;

// Bits of "echoes".
constexpr std::uint8_t kMultipleReturns = 1;  // the pulse came back more than once
constexpr std::uint8_t kNotLastReturn = 2;    // and this is not its last echo

// Bounding box of 1,024 consecutive points of a block, relative to its tile's corner.
struct ChunkBox {
  std::uint32_t min[3];
  std::uint32_t max[3];
};

// The place of a point in the inputs: file in the upper 20 bits, row in the lower 44.
using InputOrder = std::uint64_t;
constexpr int kRowBits = 44;
constexpr InputOrder input_order(std::uint64_t file, std::uint64_t row) {
  return file << kRowBits | row;
}
constexpr std::uint64_t file_of(InputOrder order) {
  return order >> kRowBits;
}
constexpr std::uint64_t row_of(InputOrder order) {
  return order & ((InputOrder{1} << kRowBits) - 1);
}

}  // namespace ilot
