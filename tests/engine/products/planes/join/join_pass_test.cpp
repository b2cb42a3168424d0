// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/join_pass.h"

#include <gtest/gtest.h>

#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

constexpr std::int64_t kBorder = 1 << 15;  // cells are 2^15 millimetres wide, tiles 2^21

// Two surfaces that meet where x = border, 100 units apart, noise 5; the second is `up` higher.
std::vector<Index3> across(std::int64_t border, double slope, double up) {
  std::vector<Index3> points;
  const auto height = [&](double x, double) { return slope * (x - static_cast<double>(border)); };
  test::add_surface(points, {border - 3000, 4000, 1000}, {3000, 3000, 0}, 100, 5, height);
  test::add_surface(points, {border, 4000, 1000}, {3000, 3000, 0}, 100, 5,
                    [&](double x, double y) { return height(x, y) + up; });
  return points;
}

TEST(JoinPass, APlaneCutByABorderOfCellsOrTilesBecomesOne) {
  for (const std::int64_t border : {kBorder, std::int64_t{0}}) {
    const PlaneStore s(across(border, 0.3, 0));
    EXPECT_EQ(s.found.cell_of.size(), 2u);
    ASSERT_EQ(s.joined.planes.size(), 1u) << border;
    EXPECT_EQ(s.joined.of_segment, (std::vector<std::uint32_t>{1, 1}));
    const Vec3 n = s.joined.planes[0].plane.n;
    EXPECT_NEAR(n.x / n.z, -0.3, 0.003);
    EXPECT_GT(s.joined.planes[0].points, 1700u);
  }
}

TEST(JoinPass, TwoPlanesAtAStepStayTwo) {
  const PlaneStore s(across(kBorder, 0.0, 150));
  ASSERT_EQ(s.joined.planes.size(), 2u);
  EXPECT_EQ(s.joined.of_segment, (std::vector<std::uint32_t>{1, 2}));
}

TEST(JoinPass, PlanesThatMeetAtAnAngleStayTwo) {
  std::vector<Index3> points = across(kBorder, 0.0, 0);
  for (Index3& p : points) p.z += p.x > kBorder ? (p.x - kBorder) / 8 : 0;  // 7 degrees
  EXPECT_EQ(PlaneStore(points).joined.planes.size(), 2u);
}

TEST(JoinPass, ContactsNameNeighboursOnly) {
  std::vector<Index3> points = across(kBorder, 0.1, 0);
  const std::size_t near = points.size();
  for (const Index3& p : across(kBorder, 0.1, 0)) points.push_back({p.x, p.y + 200000, p.z});
  ASSERT_EQ(points.size(), 2 * near);
  const PlaneStore s(points);
  EXPECT_EQ(s.joined.planes.size(), 2u);
  ASSERT_EQ(s.contacts.size(), 2u);
  for (const Contact& c : s.contacts) {
    EXPECT_LT(c.a, c.b);
    EXPECT_GT(c.count, 30u);
    EXPECT_NE(s.found.cell_of[c.a], s.found.cell_of[c.b]);
  }
}

// The reach differs from cell to cell; which cells share a block with a point must not show in its contacts.
TEST(JoinPass, ContactsDoNotKnowTheBlocks) {
  std::vector<Index3> points;
  const auto flat = [](double, double) { return 0.0; };
  test::add_surface(points, {kBorder - 4000, 4000, 1000}, {4000, 8000, 0}, 80, 5, flat);
  test::add_surface(points, {kBorder, 4000, 1000}, {28000, 28000, 0}, 400, 5, flat);
  const PlaneStore whole(points), cut(points, {300, 1u << 20, 1});
  ASSERT_GT(cut.cloud.store().blocks().size(), 4u);
  ASSERT_EQ(whole.found.cells.size(), 2u);
  EXPECT_GT(whole.found.cells[1].connectivity, 2 * whole.found.cells[0].connectivity);
  ASSERT_EQ(whole.contacts.size(), cut.contacts.size());
  for (std::size_t i = 0; i < whole.contacts.size(); ++i) {
    EXPECT_EQ(whole.contacts[i].a, cut.contacts[i].a);
    EXPECT_EQ(whole.contacts[i].b, cut.contacts[i].b);
    EXPECT_EQ(whole.contacts[i].count, cut.contacts[i].count);
  }
}

TEST(JoinPass, SmallPlanesAreDroppedAndOrderOfContactsDoesNotShow) {
  const PlaneStore s(across(kBorder, 0.0, 0));
  const Store& store = s.cloud.store();
  CellPlanes greedy = s.found;
  for (CellSummary& c : greedy.cells) c.min_points = 100000;
  const JoinedPlanes none = join_planes(store, s.cells, greedy, s.contacts, {0.99});
  EXPECT_TRUE(none.planes.empty());
  EXPECT_EQ(none.of_segment, (std::vector<std::uint32_t>{0, 0}));
  const JoinedPlanes apart = join_planes(store, s.cells, s.found, {}, {0.99});
  EXPECT_EQ(apart.of_segment, (std::vector<std::uint32_t>{1, 2}));
  const JoinedPlanes single = join_planes(store, s.cells, s.found, {{0, 1, 1}}, {0.99});
  EXPECT_EQ(single.planes.size(), 2u) << "one contact is chance";
  greedy.cells[1].min_points = 30;
  const JoinedPlanes lenient = join_planes(store, s.cells, greedy, s.contacts, {0.99});
  ASSERT_EQ(lenient.planes.size(), 1u) << "the fewest that any of its cells asks for";
  EXPECT_EQ(lenient.planes[0].min_points, 30u);
}

}  // namespace
}  // namespace ilot
