// SPDX-License-Identifier: Apache-2.0
// Reads rows of an input and gives the places of its points on the lattice, without those that a run leaves out.
#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/store/lattice.h"
#include "engine/store/row_places.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// The reasons for which a point is not in the store.
enum class Rejection { invalid, withheld, noise, outside, stray };
constexpr std::size_t kRejections = 5;
constexpr std::array<const char*, kRejections> kRejectionNames{"invalid coordinates", "withheld", "noise class",
                                                               "outside the area and its surroundings",
                                                               "stand alone, far from all other points"};

struct IndexFilter {
  std::bitset<256> noise;          // classes to leave out
  std::optional<IndexBox> keep;    // lattice box; points outside are left out
  std::optional<int> coarse_bits;  // of the cells from which strays are found; none: strays are kept
};

constexpr std::size_t kMostOffLattice = 1000;  // greatest number of places beside the lattice that are kept

constexpr int kRunRowBits = 34;  // of the number of a row in a sorted run
constexpr std::uint64_t kMostRowsOfInput = std::uint64_t{1} << kRunRowBits;

struct RowSource {
  PointReader& reader;
  std::uint32_t file = 0;              // number of the input
  std::uint64_t first = 0, count = 0;  // rows
  PlaceKeeper* places = nullptr;       // gets all rows; null: none are kept
};

struct LatticePoint {
  Index3 at;
  std::uint64_t row = 0;
  std::uint8_t classification = 0;
  std::uint8_t echoes = 0;  // kMultipleReturns, kNotLastReturn
};

// Some rows, front to back.
struct LatticeRows {
  std::vector<LatticePoint> points;
  std::vector<Index3> outside;  // of IndexFilter::keep
  std::uint64_t rows = 0;       // that were read
};

// Reads a source once, some thousand rows at a time.
class LatticeRowReader {
 public:
  // Throws Error where the input has more rows than an order of the input can number.
  LatticeRowReader(const RowSource& source, const InputLattice& lattice, const IndexFilter& filter);

  // Replaces `rows` by the next ones; false when there are none left. Throws Error where the input ends too early.
  bool next(LatticeRows& rows);

  // Of the rows that were read; strays are not among them.
  const std::array<std::uint64_t, kRejections>& rejected() const { return rejected_; }
  // In the finest steps of the inputs: places that are not a multiple of the lattice, each once, ascending.
  std::vector<Index3> off_lattice() const;

 private:
  void check_lattice(const PointFields& fields);

  RowSource source_;
  IndexFilter filter_;
  std::int64_t multiple_;
  LatticeMap map_, finest_;
  std::uint64_t batch_, done_ = 0;
  std::vector<std::byte> records_;
  std::vector<std::uint8_t> valid_;
  std::array<std::uint64_t, kRejections> rejected_{};
  std::set<std::tuple<std::int64_t, std::int64_t, std::int64_t>> off_;
};

}  // namespace ilot
