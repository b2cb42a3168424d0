// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/panes.h"

#include <gtest/gtest.h>

#include <utility>

namespace ilot {
namespace {

FoundRectangle pane(const Box2& box, double error = 0.01) {
  FoundRectangle r;
  r.side(Side::left) = {box.u0, error}, r.side(Side::right) = {box.u1, error};
  r.side(Side::bottom) = {box.v0, error}, r.side(Side::top) = {box.v1, error};
  r.points = 100;
  return r;
}

TEST(Panes, FourInAGridAreOneWindowThoughAnInnerSideIsWrong) {
  // The left side of the lower right pane was found in the pane beside it.
  std::vector<FoundRectangle> found{pane({1, 1.66, 1, 1.66}), pane({1.5, 2.38, 1, 1.66}), pane({1, 1.66, 1.72, 2.38}),
                                    pane({1.72, 2.38, 1.72, 2.38})};
  found[1].side(Side::right).error = 0.004;
  join_panes(0.04, found.size(), found);
  ASSERT_EQ(found.size(), 1u);
  const Box2 box = found[0].box();
  EXPECT_DOUBLE_EQ(box.u0, 1);
  EXPECT_DOUBLE_EQ(box.u1, 2.38);
  EXPECT_DOUBLE_EQ(box.v0, 1);
  EXPECT_DOUBLE_EQ(box.v1, 2.38);
  EXPECT_DOUBLE_EQ(found[0].error(Side::right), 0.004);  // the better known one of two that end alike
  EXPECT_EQ(found[0].points, 400u);
}

TEST(Panes, CasementsBelowATransomLightAreOneWindow) {
  std::vector<FoundRectangle> found{pane({1, 1.5, 1, 2.2}), pane({1.58, 2.08, 1, 2.2}), pane({1, 2.08, 2.28, 2.7})};
  join_panes(0.04, found.size(), found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::top), 2.7);
  // Three lights above two: no two of them are equal.
  found = {pane({1, 1.5, 1, 2.2}), pane({1.58, 2.08, 1, 2.2}), pane({1, 1.3, 2.28, 2.7}), pane({1.37, 1.71, 2.28, 2.7}),
           pane({1.78, 2.08, 2.28, 2.7})};
  join_panes(0.04, found.size(), found);
  EXPECT_EQ(found.size(), 1u);
}

TEST(Panes, ADoorBesideAWindowAndWindowsBesideAPierStayAlone) {
  std::vector<FoundRectangle> found{pane({1, 1.9, 0, 2.1}), pane({2, 3, 0.9, 2.1}), pane({1, 1.9, 2.2, 2.6})};
  join_panes(0.04, found.size(), found);
  EXPECT_EQ(found.size(), 2u);  // the light above the door belongs to it
  found = {pane({1, 2, 1, 2.5}), pane({2.25, 3.25, 1, 2.5})};
  join_panes(0.04, found.size(), found);
  EXPECT_EQ(found.size(), 2u);
}

TEST(Panes, NothingIsJoinedInCellsThatDoNotShowBars) {
  std::vector<FoundRectangle> found{pane({1, 1.62, 1, 2.4}), pane({1.45, 1.83, 1, 2.4})};
  join_panes(0.12, found.size(), found);
  EXPECT_EQ(found.size(), 2u);
  join_panes(0.04, found.size(), found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::right), 1.83);
}

TEST(Panes, OneAboveTheOtherIsJoinedInLargeCellsToo) {
  std::vector<FoundRectangle> found{pane({1, 2, 1, 1.8}), pane({1, 2, 1.9, 2.6})};
  join_panes(0.12, found.size(), found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::top), 2.6);
}

TEST(Panes, APaneWithAnArchGivesTheHead) {
  std::vector<FoundRectangle> found{pane({1, 2, 1, 1.8}), pane({1, 2, 1.86, 2.6})};
  found[1].arc = TopArc{{1.5, 2.1}, 0.5};
  join_panes(0.04, found.size(), found);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_TRUE(found[0].arc);
  EXPECT_DOUBLE_EQ(found[0].arc->radius, 0.5);
  EXPECT_DOUBLE_EQ(found[0].at(Side::bottom), 1);
  found = {pane({1, 2, 1, 1.8}), pane({1, 2, 1.86, 2.6})};
  found[0].arc = TopArc{{1.5, 1.3}, 0.5};  // a window below another one
  join_panes(0.04, found.size(), found);
  EXPECT_EQ(found.size(), 2u);
}

TEST(Panes, AnOpenHoleIsAPaneWithOneThatWasFoundOnly) {
  const FoundRectangle dusty = pane({1, 2, 1, 1.8}), clean = pane({1, 2, 1.82, 2.9});
  std::vector<FoundRectangle> found{dusty, clean};
  join_panes(0.04, 1, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::top), 2.9);
  found = {pane({5, 6, 1, 2}), clean};
  join_panes(0.04, 1, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::left), 5);
  found = {pane({1, 2, 1, 1.8}), pane({1, 2.4, 1.82, 2.9})};  // the shadow of what is wider
  join_panes(0.04, 1, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::top), 1.8);
  found = {pane({1, 1.48, 1.8, 2.9}), pane({1.52, 2, 1.8, 2.9}), dusty};  // two holes above one pane
  std::swap(found[0], found[2]);
  join_panes(0.04, 1, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::top), 2.9);
}

}  // namespace
}  // namespace ilot
