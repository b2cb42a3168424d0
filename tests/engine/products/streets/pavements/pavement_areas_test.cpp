// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/pavement_areas.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

PavementWidth width_at(std::uint32_t kerb, std::uint32_t number, double width, PavementEnd end = PavementEnd::wall) {
  PavementWidth w;
  w.kerb = kerb, w.number = number, w.width_m = width, w.passable_m = width - 0.5, w.end = end;
  w.from = {number + 0.5, 10.0 * kerb, 1}, w.to = {number + 0.5, 10.0 * kerb + width, 1};
  w.unseen_share = 0.2;
  return w;
}

TEST(PavementAreas, ConsecutiveWidthsAreJoined) {
  const std::vector<PavementWidth> widths{
      width_at(1, 1, 2), width_at(1, 2, 2),   width_at(1, 3, 3),   width_at(1, 4, 6, PavementEnd::open),
      width_at(1, 5, 2), width_at(2, 1, 1.5), width_at(2, 2, 1.5), width_at(2, 4, 1.5)};
  const std::vector<Pavement> all = join_pavements(widths, 1);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].id, 1u);
  EXPECT_EQ(all[0].ring.size(), 6u);
  EXPECT_NEAR(all[0].area_m2, 2 + 2.5, 1e-9);
  EXPECT_NEAR(all[0].length_m, 2, 1e-9);
  EXPECT_NEAR(all[0].width_m, 2, 1e-9);
  EXPECT_NEAR(all[0].passable_m, 1.5, 1e-9);
  EXPECT_NEAR(all[0].unseen_share, 0.2, 1e-9);
  EXPECT_EQ(all[1].kerb, 2u);
  EXPECT_NEAR(join_pavements(widths, 0.3048)[0].area_m2, 4.5 * 0.3048 * 0.3048, 1e-9);
}

TEST(PavementAreas, WidthsThatMeetAtATurnAreApart) {
  std::vector<PavementWidth> widths{width_at(1, 1, 2), width_at(1, 2, 2)};
  widths[1].to.x = 1;  // before the first one's end
  EXPECT_TRUE(join_pavements(widths, 1).empty());
}

TEST(PavementAreas, AWidthThatNoNeighbourConfirmsIsUnsure) {
  std::vector<PavementWidth> widths{width_at(1, 1, 2), width_at(1, 2, 4.5), width_at(1, 3, 2.1), width_at(2, 1, 4.5)};
  mark_unsure_widths(widths);
  EXPECT_EQ(widths[0].end, PavementEnd::wall);
  EXPECT_EQ(widths[1].end, PavementEnd::unsure);
  EXPECT_EQ(widths[2].end, PavementEnd::wall);
  EXPECT_EQ(widths[3].end, PavementEnd::unsure);
}

}  // namespace
}  // namespace ilot
