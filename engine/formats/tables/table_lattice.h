// SPDX-License-Identifier: Apache-2.0
// Converts coordinates that are given as numbers to 32-bit integers: it chooses scale and offset.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

constexpr std::size_t kSample = 1000;  // rows from which columns, lattices and dialects are found

struct TableLattice {
  static constexpr int kUnknown = -1;
  std::array<double, 3> scale{1e-4, 1e-4, 1e-4}, offset{0, 0, 0};
  int decimals = kUnknown;         // decimals of the numbers
  int kept = 4;                    // decimals of the scale
  std::uint64_t beyond = 0;        // rows that do not fit; rows of zeros are not counted
  std::uint64_t zeros_beyond = 0;  // rows at the exact origin that do not fit
};

// Examines all rows, or a sample, then chooses. The offset is the multiple of 1000 at or below the first point that is
// not isolated. The scale is 1e-4, or 1e-5 or 1e-6 when the numbers have more decimals and fit. It is coarser by powers
// of ten (up to 1e-2) when the points do not fit in 32 bits. Two kinds of rows never cause a coarser scale than 1e-4:
// any number of rows at the exact origin (rays without an echo), and up to one in a hundred rows (at least one of
// three) beyond the range. O(rows), 1000 rows kept.
class LatticeSurvey {
 public:
  // With `degrees`, x and y are degrees, and their steps are 1e5 times smaller.
  explicit LatticeSurvey(bool degrees = false) : factor_(degrees ? 1e5 : 1) {}

  void add(Vec3 place, int decimals = TableLattice::kUnknown);
  TableLattice choose();

  // For a sample. Rows beyond the range are not counted, because their total number is not known.
  TableLattice choose_for_sample() {
    TableLattice lattice = choose();
    lattice.beyond = lattice.zeros_beyond = 0;
    return lattice;
  }

 private:
  static constexpr int kBands = 6;  // 2e3, 2e4 ... 2e7 from the offset, and beyond

  void choose_offset();
  void count(Vec3 place);
  std::optional<std::size_t> first_not_isolated() const;

  double factor_;
  std::vector<Vec3> sample_;  // the first rows that are not at the origin
  std::optional<Vec3> first_;
  std::array<double, 3> offset_{};
  std::array<std::uint64_t, kBands> bands_{};
  std::uint64_t zeros_ = 0, rows_ = 0;
  int decimals_ = TableLattice::kUnknown;
  bool has_offset_ = false;
};

}  // namespace ilot
