// SPDX-License-Identifier: Apache-2.0
// First half of the index: each stretch of the inputs becomes a file of points sorted by key. Which stretch a point
// fell into never shows: blocks merge what all runs hold of an octree node.
#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/store/lattice.h"
#include "engine/store/store.h"

namespace ilot {

// Why a point did not enter the store.
enum class Rejection { invalid, withheld, noise, outside };
constexpr std::size_t kRejections = 4;
constexpr std::array<const char*, kRejections> kRejectionNames{"invalid coordinates", "withheld", "noise class",
                                                               "outside the area and its surroundings"};

struct IndexFilter {
  std::bitset<256> noise;        // classes that are left out
  std::optional<IndexBox> keep;  // lattice box beyond which points are left out
};

// The points of one tile in a run: positions [first, end) of the run's columns.
struct RunTile {
  Tile tile;
  std::uint64_t first = 0, end = 0;
};

constexpr std::uint64_t kRunSample = 1024;  // every 1,024th code of the run is kept in memory

struct SortedRun {
  std::filesystem::path stem;  // stem.points: KeyValue of code and RunValue; stem.table is written last
  std::array<std::uint64_t, kRejections> rejected{};
  std::vector<RunTile> tiles;          // ascending
  std::vector<std::uint64_t> samples;  // code at position i * kRunSample
};

// What a run keeps of a point beside its code, so that sorting carries it along: the input order in the upper 54 bits,
// then 8 bits of class and 2 of echoes.
using RunValue = std::uint64_t;
constexpr int kRunRowBits = 34;
constexpr std::uint64_t kMostRowsOfInput = std::uint64_t{1} << kRunRowBits;
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

struct RunSource {
  PointReader& reader;
  std::uint32_t file = 0;              // number of the input
  std::uint64_t first = 0, count = 0;  // rows
};

// Reads rows and writes stem.*; 64 bytes of memory a row. `read_rows` is told how many rows were read.
SortedRun make_sorted_run(const RunSource& source, double unit, const IndexFilter& filter,
                          const std::filesystem::path& stem, const std::function<void(std::uint64_t)>& read_rows);

// The table of a run that an earlier start finished; nullopt when there is none.
std::optional<SortedRun> find_sorted_run(const std::filesystem::path& stem);

// stem.points and its siblings.
inline std::filesystem::path with_suffix(std::filesystem::path stem, const char* suffix) {
  return stem += suffix;
}

}  // namespace ilot
