// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/box3.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

Index3 small_place(Rng& rng) {
  const auto draw = [&] { return static_cast<std::int64_t>(rng.below(7)) - 3; };
  return {draw(), draw(), draw()};
}

IndexBox small_box(Rng& rng) {
  IndexBox box = IndexBox::none();
  box.add(small_place(rng));
  box.add(small_place(rng));
  return box;
}

TEST(Box3, NoneTakesAnyFirstPoint) {
  EXPECT_TRUE(IndexBox::none().is_empty());
  EXPECT_TRUE(Box3<Vec3>::none().is_empty());
  IndexBox box = IndexBox::none();
  box.add({5, -7, 9});
  EXPECT_EQ(box, (IndexBox{{5, -7, 9}, {5, -7, 9}}));
  EXPECT_FALSE(box.is_empty());
  IndexBox all = IndexBox::none();
  all.add_box(box);
  EXPECT_EQ(all, box);
}

// Closed: two boxes intersect when some lattice point lies in both.
TEST(Box3, IntersectsWhereAPointIsInBoth) {
  Rng rng(4);
  for (int round = 0; round < 300; ++round) {
    const IndexBox a = small_box(rng), b = small_box(rng);
    IndexBox both = a;
    both.add_box(b);
    bool common = false;
    for (std::int64_t z = -4; z <= 4; ++z)
      for (std::int64_t y = -4; y <= 4; ++y)
        for (std::int64_t x = -4; x <= 4; ++x) {
          const Index3 p{x, y, z};
          common |= a.contains(p) && b.contains(p);
          EXPECT_GE(both.contains(p), a.contains(p) || b.contains(p));
          EXPECT_GE(a.grown(1).contains({x + 1, y - 1, z + 1}), a.contains(p));
        }
    EXPECT_EQ(a.intersects(b), common);
    EXPECT_EQ(b.intersects(a), common);
  }
}

TEST(Box3, AColumnHoldsAllHeights) {
  const IndexBox column = column_over(-2, 3, 5, 9);
  EXPECT_TRUE(column.contains({-2, 9, std::int64_t{1} << 51}));
  EXPECT_TRUE(column.contains({5, 3, -(std::int64_t{1} << 51)}));
  EXPECT_FALSE(column.contains({6, 3, 0}));
}

}  // namespace
}  // namespace ilot
