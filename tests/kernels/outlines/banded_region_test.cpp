// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/banded_region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

BandedRegion region_of(const std::vector<std::vector<FlatPoint>>& rings) {
  std::vector<FlatEdge> edges;
  for (const auto& ring : rings) add_ring(ring, edges);
  return BandedRegion(edges);
}

TEST(BandedRegion, ContainsWhatIsInsideButForHoles) {
  const BandedRegion region = region_of({{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}});
  EXPECT_TRUE(region.contains({0.5, 0.5}));
  EXPECT_TRUE(region.contains({3, 2.5}));
  EXPECT_FALSE(region.contains({1.5, 1.5})) << "the hole";
  for (const FlatPoint p : {FlatPoint{-1, 1}, {5, 1}, {1, -1}, {1, 4}, {1e9, 1}, {1, -1e9}})
    EXPECT_FALSE(region.contains(p)) << p.x << " " << p.y;
}

TEST(BandedRegion, OfNothingContainsNothing) {
  EXPECT_FALSE(BandedRegion().contains({0, 0}));
  EXPECT_FALSE(BandedRegion(std::vector<FlatEdge>{}).contains({0, 0}));
  EXPECT_FALSE(region_of({{{0, 0}, {1, 0}, {2, 0}}}).contains({0.5, 0}));
}

// A star of many corners, against the sum of the angles that its edges span.
TEST(BandedRegion, AgreesWithTheWindingOfManyCorners) {
  Rng rng(5);
  constexpr int kCorners = 500;
  std::vector<FlatPoint> star;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners, radius = 1 + 3 * rng.uniform();
    star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const BandedRegion region = region_of({star});
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x = 10 * rng.uniform() - 5, y = 10 * rng.uniform() - 5;
    double turned = 0;
    for (int k = 0; k < kCorners; ++k) {
      const FlatPoint a = star[static_cast<std::size_t>(k)], b = star[static_cast<std::size_t>((k + 1) % kCorners)];
      turned +=
          std::atan2((a.x - x) * (b.y - y) - (a.y - y) * (b.x - x), (a.x - x) * (b.x - x) + (a.y - y) * (b.y - y));
    }
    const bool wound = std::abs(turned) > M_PI;
    ASSERT_EQ(region.contains({x, y}), wound) << x << " " << y;
    inside += wound;
  }
  EXPECT_GT(inside, 300);
}

TEST(BandedRegion, NeighboursShareNoPlaceAndLoseNone) {
  const BandedRegion left = region_of({{{0, 0}, {1, 0}, {2, 2}, {0, 2}}}),
                     right = region_of({{{1, 0}, {3, 0}, {3, 2}, {2, 2}}});
  for (int i = 0; i < 8; ++i) {
    const FlatPoint on_border{1 + i / 8.0, i / 4.0};
    EXPECT_NE(left.contains(on_border), right.contains(on_border)) << i;
  }
}

}  // namespace
}  // namespace ilot
