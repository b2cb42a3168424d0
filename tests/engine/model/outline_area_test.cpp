// SPDX-License-Identifier: Apache-2.0
#include "engine/model/outline_area.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

Outline::Ring square(double x, double edge) {
  return {{x, 7, x}, {x + edge, 7, x}, {x + edge, 7, x + edge}, {x, 7, x + edge}};
}

TEST(OutlineArea, PartsAddUpAndHolesDoNotCount) {
  const Outline two{1, {{square(600000, 4), square(600001, 1), square(600002.5, 1)}, {square(5, 2)}}};
  EXPECT_NEAR(area_of(two), 16 - 2 + 4, 1e-9);
  EXPECT_EQ(area_of(Outline{}), 0);
}

TEST(OutlineArea, ARingMayBeConcave) {
  const Outline notched{1, {{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}}}};
  EXPECT_NEAR(area_of(notched), 16 - 6, 1e-12);
}

}  // namespace
}  // namespace ilot
