// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/lattice_cells.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

// Around every corner of a cell that a product could miss, near and as far as a cloud reaches.
TEST(LatticeCells, AsByDivision) {
  for (const std::int64_t units : {1, 2, 3, 7, 10, 49, 50, 64, 333, 1000, 1023, 999983}) {
    const LatticeCells cell_of(units);
    for (const std::int64_t first : {0, 1, 5, 4194303, 4294000})
      for (std::int64_t cell = first; cell < first + 100; ++cell)
        for (const std::int64_t v : {cell * units, cell * units + units / 2, cell * units + units - 1})
          ASSERT_EQ(cell_of(v), v / units) << v << " in " << units;
  }
}

}  // namespace
}  // namespace ilot
