// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/seams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ilot {
namespace {

// A level square of 128 m with a point each 25 cm, in steps of 1 cm; cells of 40.96 m.
constexpr SeamCells kSeamCells{0.01, 4096, 1 << 18};

SeamPoints seam_square(const std::function<std::uint32_t(Index3)>& plane) {
  SeamPoints points;
  for (std::int64_t x = 0; x < 12800; x += 25)
    for (std::int64_t y = 0; y < 12800; y += 25) {
      points.places.push_back({x + 7, y + 7, 300});
      points.plane.push_back(plane(points.places.back()));
    }
  return points;
}

std::uint32_t by_cell(Index3 p) {
  return static_cast<std::uint32_t>(1 + p.x / 4096 * 8 + p.y / 4096);
}

TEST(Seams, PlanesThatEndAtEveryBorderAreCutThereAndNowhereElse) {
  const Seams seams = measure_seams(seam_square(by_cell), kSeamCells, {}, 1);
  EXPECT_GT(seams.borders.stretches, 1000u);
  EXPECT_EQ(seams.borders.share(), 1.0);
  EXPECT_GT(seams.elsewhere.stretches, 7000u);
  EXPECT_EQ(seams.elsewhere.share(), 0.0);
  EXPECT_EQ(seams.planes, 16u);
}

TEST(Seams, PlanesThatDoNotKnowTheCellsAreCutAlikeEverywhere) {
  const auto oblique = [](Index3 p) { return static_cast<std::uint32_t>(1 + (p.x + 2 * p.y) / 1371); };
  const Seams seams = measure_seams(seam_square(oblique), kSeamCells, {}, 1);
  EXPECT_NEAR(*seams.borders.share(), *seams.elsewhere.share(), 0.02);
  EXPECT_GT(*seams.elsewhere.share(), 0.005);
}

TEST(Seams, StepsAreNoSmoothSurfaceAndPointsWithoutAPlaneAreCut) {
  SeamPoints points = seam_square([](Index3) { return 0u; });
  EXPECT_EQ(measure_seams(points, kSeamCells, {}, 1).borders.share(), 1.0);
  for (Index3& p : points.places) p.z += p.x / 4096 * 20;
  const Seams seams = measure_seams(points, kSeamCells, {}, 1);
  EXPECT_LT(seams.borders.stretches, 1000u) << "only the borders across which nothing rises";
  EXPECT_EQ(seams.unlabelled, points.places.size());
}

TEST(Seams, CellsWithTooManyPointsAreCutAsTheSearchCutsThem) {
  SeamCells small = kSeamCells;
  small.points = 20000;  // a cell has 26,800 points
  const auto quarters = [](Index3 p) { return static_cast<std::uint32_t>(1 + p.x / 2048 * 64 + p.y / 2048); };
  const Seams seams = measure_seams(seam_square(quarters), small, {}, 1);
  EXPECT_GT(*seams.borders.share(), 0.99);
  EXPECT_LT(*seams.elsewhere.share(), 0.05);  // the cells at the rim are not full
}

TEST(Seams, PairsOfTwoResults) {
  const SeamPoints points = seam_square(by_cell);
  const PairCounts same = compare_pairs(points, points.plane, 0.01, {});
  EXPECT_EQ(same.share(), 1.0);
  EXPECT_EQ(same.different, same.different_other);
  const PairCounts other = compare_pairs(points, std::vector<std::uint32_t>(points.plane.size(), 5), 0.01, {});
  EXPECT_EQ(other.different_other, 0u);
  EXPECT_EQ(other.pairs - other.equal, other.different);
}

}  // namespace
}  // namespace ilot
