// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/flat_box.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

FlatBox drawn_flat_box(Rng& rng) {
  FlatBox box = FlatBox::none();
  for (int i = 0; i < 2; ++i) box.add({static_cast<double>(rng.below(8)), static_cast<double>(rng.below(8))});
  return box;
}

TEST(FlatBox, NoneTakesAnyFirstPoint) {
  FlatBox box = FlatBox::none();
  EXPECT_TRUE(box.is_empty());
  box.add({3, -4});
  EXPECT_FALSE(box.is_empty());
  EXPECT_EQ(box.width(), 0);
  box.add({1, 6});
  EXPECT_EQ(box.width(), 2);
  EXPECT_EQ(box.height(), 10);
  EXPECT_EQ(box.middle().x, 2);
  EXPECT_EQ(box.middle().y, 1);
}

// Boxes overlap when the middle of some cell of the lattice lies in both; a box holds another when it holds its points.
TEST(FlatBox, OverlapAndContain) {
  Rng rng(9);
  for (int round = 0; round < 500; ++round) {
    const FlatBox a = drawn_flat_box(rng), b = drawn_flat_box(rng);
    if (a.width() * a.height() == 0 || b.width() * b.height() == 0) continue;
    bool common = false, all = true;
    for (double y = -1; y <= 8; y += 0.5)
      for (double x = -1; x <= 8; x += 0.5) {
        const FlatPoint p{x, y};
        common |= x != std::floor(x) && y != std::floor(y) && a.contains(p) && b.contains(p);
        if (b.contains(p)) all &= a.contains(p);
        EXPECT_EQ(a.grown(0.5).contains(p),
                  a.contains(FlatPoint{x + 0.5, y + 0.5}) || a.contains(FlatPoint{x - 0.5, y + 0.5}) ||
                      a.contains(FlatPoint{x + 0.5, y - 0.5}) || a.contains(FlatPoint{x - 0.5, y - 0.5}));
      }
    EXPECT_EQ(a.overlaps(b), common);
    EXPECT_EQ(a.contains(b), all);
  }
}

}  // namespace
}  // namespace ilot
