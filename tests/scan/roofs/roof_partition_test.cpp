// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_partition.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scan/roofs/roof_styles.h"
#include "scan/roofs/roof_wings.h"

namespace ilot::scan {
namespace {

bool inside(const Piece& piece, const Spot& spot) {
  return std::all_of(piece.begin(), piece.end(), [&](const Corner& c) { return side(c.edge, spot) > 0; });
}

TEST(RoofPartition, AGableHasTwoPiecesThatMeetInTheRidge) {
  const std::vector<Wing> wings{gable_wing({0, 0, 10000, 8000}, Axis::u, 3000, 12)};
  const std::vector<RoofPiece> pieces = partition_roof(wings);
  ASSERT_EQ(pieces.size(), 2u);
  for (const RoofPiece& piece : pieces) {
    EXPECT_EQ(piece.outline.size(), 4u);
    EXPECT_EQ(height_mm(piece.plane, 5000, 4000), 6000);
  }
  EXPECT_EQ(gable_rise(wings[0].rect, Axis::u, 12), 3000);
}

TEST(RoofPartition, EqualPlanesAreSeenOnce) {
  const std::vector<Wing> wings{flat_wing({0, 0, 1000, 1000}, 500), flat_wing({500, 0, 2000, 1000}, 500),
                                flat_wing({100, 100, 200, 200}, 400)};
  const std::vector<RoofPiece> pieces = partition_roof(wings);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_TRUE(inside(pieces[0].outline, {700, 500, 1}));
  EXPECT_TRUE(inside(pieces[1].outline, {1500, 500, 1}));
}

// Every place of the footprint lies in one piece, whose plane has the height of the highest wing there.
TEST(RoofPartition, PiecesAreWhatIsSeenFromAbove) {
  Rng rng(7);
  for (int round = 0; round < 200; ++round) {
    const RoofDesign design =
        draw_roof(rng, RoofKind::complex, round % 2 ? BuiltForm::detached : BuiltForm::terraced, 0.5);
    const std::vector<RoofPiece> pieces = partition_roof(design.wings);
    const GridRect bounds = bounds_of(design.wings);
    for (int probe = 0; probe < 60; ++probe) {
      // Numerators that no border of the lattice meets.
      const Spot spot{
          (bounds.u0 + static_cast<Integer>(rng.below(static_cast<std::uint64_t>(bounds.u1 - bounds.u0)))) * 1009 + 17,
          (bounds.v0 + static_cast<Integer>(rng.below(static_cast<std::uint64_t>(bounds.v1 - bounds.v0)))) * 1009 + 401,
          1009};
      const double u = static_cast<double>(spot.u) / 1009, v = static_cast<double>(spot.v) / 1009;
      double highest = -1;
      for (const Wing& wing : design.wings)
        if (inside(rectangle(wing.rect), spot)) highest = std::max(highest, height_mm(wing, u, v));
      int around = 0;
      for (const RoofPiece& piece : pieces) {
        if (!inside(piece.outline, spot)) continue;
        ++around;
        EXPECT_NEAR(height_mm(piece.plane, u, v), highest, 1e-6);
      }
      EXPECT_EQ(around, highest >= 0 ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace ilot::scan
