// SPDX-License-Identifier: Apache-2.0
#include "engine/store/row_order.h"

#include <gtest/gtest.h>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

TEST(RowOrder, RisesAndIsKept) {
  const test::CloudStore cloud(test::points_over_tiles(3000, 2), {500, 1u << 20, 2});
  const Store& store = cloud.store();
  ASSERT_GT(store.blocks().size(), 2u);
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    const auto order = store.read(b, columns::kOrder);
    EXPECT_FALSE(store.has(b, columns::kSorted));
    const auto points = points_by_row(store, b, order);
    ASSERT_EQ(points.size(), order.size());
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LT(order[points[i - 1]], order[points[i]]);
    EXPECT_EQ(points_by_row(store, b, {}), points) << "read, not sorted again";
  }
}

}  // namespace
}  // namespace ilot
