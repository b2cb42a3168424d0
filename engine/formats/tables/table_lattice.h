// SPDX-License-Identifier: Apache-2.0
// Coordinates that come as numbers become 32-bit integers: with which scale and offset.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

struct TableLattice {
  static constexpr int kUnknown = -1;
  std::array<double, 3> scale{1e-4, 1e-4, 1e-4}, offset{0, 0, 0};
  int decimals = kUnknown;         // that the numbers carry
  int kept = 4;                    // decimals of the scale
  std::uint64_t beyond = 0;        // rows that do not fit, rows of zeros not counted
  std::uint64_t zeros_beyond = 0;  // rows at the exact origin that do not fit
};

// Looks at all rows, or at a sample, then chooses. The offset is the multiple of 1000 at or below the first point that
// is not alone. The scale is 1e-4, or 1e-5 or 1e-6 where the numbers carry more decimals and fit; coarser by powers of
// ten (to 1e-2) where the points do not fit in 32 bits. Two kinds of rows never ask for a coarser scale than 1e-4: rows
// at the exact origin (rays without an echo), however many, and up to one in a hundred rows (at least one of three)
// beyond the range. O(rows), 1000 rows kept.
class LatticeSurvey {
 public:
  // With `degrees` x and y are degrees, whose steps are 1e5 times smaller.
  explicit LatticeSurvey(bool degrees = false) : factor_(degrees ? 1e5 : 1) {}

  void add(Vec3 place, int decimals = TableLattice::kUnknown);
  TableLattice choose();

  // For a sample: rows beyond are not counted, for nobody knows how many there are.
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
