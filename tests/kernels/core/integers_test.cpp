// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/integers.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(FloorDivided, CellsHoldTheirNumbers) {
  for (std::int64_t b = 1; b <= 9; ++b)
    for (std::int64_t a = -100; a <= 100; ++a) {
      const std::int64_t cell = floor_divided(a, b);
      EXPECT_LE(cell * b, a);
      EXPECT_LT(a, (cell + 1) * b);
    }
  EXPECT_EQ(floor_divided(INT64_MIN, 1), INT64_MIN);
  EXPECT_EQ(floor_divided(INT64_MAX, 2), INT64_MAX / 2);
}

}  // namespace
}  // namespace ilot
