// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/lattice_geometry.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

double area(const Piece& piece) {
  double sum = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Spot &a = piece[i].at, &b = piece[(i + 1) % piece.size()].at;
    sum += (static_cast<double>(a.u) * static_cast<double>(b.v) - static_cast<double>(b.u) * static_cast<double>(a.v)) /
           (static_cast<double>(a.w) * static_cast<double>(b.w));
  }
  return sum / 2;
}

TEST(LatticeGeometry, LinesMeetInReducedSpots) {
  EXPECT_EQ(meet({2, 0, -3}, {0, 4, -6}), (Spot{3, 3, 2}));
  EXPECT_EQ(meet({0, 4, -6}, {2, 0, -3}), (Spot{3, 3, 2}));
  EXPECT_EQ(side({1, 0, -1}, {3, 3, 2}), 1);
  EXPECT_EQ(side({2, 0, -3}, {3, 3, 2}), 0);
  EXPECT_EQ(side({-1, -1, 0}, {3, 3, 2}), -1);
}

TEST(LatticeGeometry, ClippingKeepsCornersAndSides) {
  const Piece square = rectangle({0, 0, 10, 10});
  const Piece half = clip(square, {-2, -2, 20});  // u + v <= 10, through two corners
  ASSERT_EQ(half.size(), 3u);
  EXPECT_EQ(area(half), 50);
  for (std::size_t i = 0; i < half.size(); ++i) {
    EXPECT_EQ(side(half[i].edge, half[i].at), 0);
    EXPECT_EQ(side(half[i].edge, half[(i + 1) % half.size()].at), 0);
  }
  EXPECT_TRUE(clip(square, {1, 0, -10}).empty());
  EXPECT_EQ(clip(square, {1, 0, 0}).size(), 4u);
}

TEST(LatticeGeometry, SubtractionCutsThePieceWithoutOverlap) {
  const Piece square = rectangle({0, 0, 100, 100});
  Rng rng(1);
  for (int round = 0; round < 300; ++round) {
    std::vector<GridLine> hole;
    for (int i = 0; i < 5; ++i) {
      const auto draw = [&](Integer reach) {
        return static_cast<Integer>(rng.below(2 * static_cast<std::uint64_t>(reach) + 1)) - reach;
      };
      const GridLine line{draw(20), draw(20), draw(1200)};
      if (line.a != 0 || line.b != 0) hole.push_back(line);
    }
    Piece inner = square;
    for (const GridLine& line : hole) inner = clip(inner, line);
    double outside = 0;
    for (const Piece& piece : subtract(square, hole)) {
      EXPECT_GT(area(piece), 0);
      outside += area(piece);
      for (std::size_t i = 0; i < piece.size(); ++i)
        EXPECT_EQ(side(piece[i].edge, piece[(i + 1) % piece.size()].at), 0);
    }
    EXPECT_NEAR(outside + area(inner), 10000, 1e-6);
  }
}

}  // namespace
}  // namespace ilot::scan
