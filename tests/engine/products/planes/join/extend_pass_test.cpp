// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/extend_pass.h"

#include <gtest/gtest.h>

#include "engine/compare/seams.h"
#include "engine/products/planes/join/label_pass.h"
#include "engine/store/extended_columns.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

constexpr std::int64_t kExtendCell = 1 << 15;  // cells are 2^15 millimetres wide

// A round hill on which no plane is longer than some ten metres, over four cells; a point each half metre, noise 15 mm.
std::vector<Index3> round_hill() {
  std::vector<Index3> points;
  const auto at = static_cast<double>(kExtendCell);
  test::add_surface(points, {kExtendCell - 26000, kExtendCell - 22000, 5000}, {48000, 48000, 0}, 400, 15,
                    [&](double x, double y) {
                      return -((x - at + 3000) * (x - at + 3000) + (y - at - 2000) * (y - at - 2000)) / 900000;
                    });
  return points;
}

SeamPoints labelled(const Store& store, const Column<std::uint32_t>& column) {
  return {test::positions(store), test::whole_column(store, column)};
}

// The planes of all points after all rounds.
std::vector<std::uint32_t> extended(const Store& store, const JoinedPlanes& joined) {
  std::vector<std::uint32_t> planes(store.points());
  std::size_t at = 0;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    const std::uint32_t points = store.blocks()[b].points;
    read_extended(store, joined, b, 0, std::span(planes).subspan(at, points));
    at += points;
  }
  return planes;
}

constexpr SeamCells kHillCells{1, kExtendCell, kCellPoints};
constexpr SeamParams kHillParams{500, 500, 200};

TEST(ExtendPass, PlanesOfABentSurfaceDoNotEndAtTheBordersOfCells) {
  const PlaneStore s(round_hill());
  const Store& store = s.cloud.store();
  label_pass(store, s.cells, s.found, s.joined, {});
  const Seams before = measure_seams(labelled(store, columns::kSegment), kHillCells, kHillParams, 1);
  const Seams after = measure_seams(labelled(store, columns::kPlane), kHillCells, kHillParams, 1);
  ASSERT_GT(before.borders.stretches, 100u);
  EXPECT_EQ(before.borders.share(), 1.0) << "planes of cells end with them";
  EXPECT_LT(*after.borders.share(), 0.35);
  EXPECT_LE(after.unlabelled, before.unlabelled);
}

TEST(ExtendPass, DoesNotKnowTheBlocks) {
  const auto points = round_hill();
  const PlaneStore one(points), many(points, {.block_points = 1024});
  ASSERT_GT(many.cloud.store().blocks().size(), one.cloud.store().blocks().size());
  EXPECT_EQ(extended(one.cloud.store(), one.joined), extended(many.cloud.store(), many.joined));
}

TEST(ExtendPass, GoesOnFromTheRoundsThatAreStored) {
  const auto points = round_hill();
  const PlaneStore s(points);
  const Store& store = s.cloud.store();
  const auto wanted = extended(store, s.joined);
  std::size_t changed = 0;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) changed += store.read(b, columns::kExtended4).size();
  ASSERT_GT(changed, 100u);
  for (const std::uint32_t first : {0u, 1u, 1000u, store.blocks()[0].points - 1}) {  // a part is read as the whole is
    std::vector<std::uint32_t> part(std::min(1000u, store.blocks()[0].points - first));
    read_extended(store, s.joined, 0, first, part);
    EXPECT_TRUE(std::equal(part.begin(), part.end(), wanted.begin() + first)) << first;
  }
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    std::filesystem::remove(store.path(b, columns::kExtended4));
    std::filesystem::remove(store.path(b, columns::kExtended2));
  }
  JoinedPlanes joined = s.joined;
  extend_pass(store, s.cells, s.found, joined, {});
  EXPECT_EQ(extended(store, joined), wanted);
}

}  // namespace
}  // namespace ilot
