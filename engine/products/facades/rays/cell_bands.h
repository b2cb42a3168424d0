// SPDX-License-Identifier: Apache-2.0
// Images of a wall in cells: the smallest size of a cell, and the bands of rows that are filled at a time.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ilot {

// The edge of a cell: at least `least`, and so large that an image of this size has at most 2^21 cells. With cells of 3
// cm that is a wall of 1,887 m2.
inline double cell_for(double width, double height, double least) {
  // Derived: 2 million cells of some bytes: a bound of memory, no result depends on it.
  constexpr double kMostCells = 1 << 21;
  return std::max(least, std::sqrt(width * height / kMostCells));
}

// The rows [first, end) of an image.
struct RowBand {
  std::int64_t first = 0, end = 0;
};

// Divides all rows into bands of 2^18 cells or of one row.
inline std::vector<RowBand> bands_of(std::int64_t columns, std::int64_t rows) {
  const std::int64_t height = std::max<std::int64_t>(1, (std::int64_t{1} << 18) / columns);
  std::vector<RowBand> bands;
  for (std::int64_t r = 0; r < rows; r += height) bands.push_back({r, std::min(rows, r + height)});
  return bands;
}

}  // namespace ilot
