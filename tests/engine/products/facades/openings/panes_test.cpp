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

TEST(Panes, InLargeCellsWhatHasNoRoomForAPierIsJoined) {
  std::vector<FoundRectangle> found{pane({1, 1.6, 1, 2.4}, 0.02), pane({1.7, 2.3, 1, 2.4}, 0.02)};
  join_panes(0.12, found.size(), found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::right), 2.3);
  found = {pane({1, 1.65, 1, 2.4}, 0.1), pane({1.55, 2.3, 1, 2.4}, 0.1)};  // one side is that of another window
  join_panes(0.12, found.size(), found);
  EXPECT_EQ(found.size(), 2u);
  found = {pane({1, 1.6, 1, 2.4}, 0.04), pane({1.7, 2.3, 1, 2.4}, 0.04)};  // the bar may be 18 cm wide
  join_panes(0.12, found.size(), found);
  EXPECT_EQ(found.size(), 2u);
}

TEST(Panes, ThoseThatEndApartAreOneWindowLikeOthersOfTheirRow) {
  const FoundRectangle whole = pane({3, 3.9, 1, 2.8});
  FoundRectangle curtained = pane({1, 1.42, 1, 2.1});
  curtained.arc = TopArc{{1.21, 1.9}, 0.25};
  std::vector<FoundRectangle> found{curtained, whole, pane({1.48, 1.9, 1, 2.5})};
  join_panes_like_others(0.04, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::left), 1);
  EXPECT_DOUBLE_EQ(found[0].at(Side::right), 1.9);
  EXPECT_TRUE(found[0].is_rectangle());
  const LocatedEdge& head = found[0].side(Side::top);  // from the higher pane to the head of its row
  EXPECT_EQ(head.status, DrawnStatus::occluded);
  EXPECT_DOUBLE_EQ(head.inner, 2.5);
  EXPECT_NEAR(head.at + head.error, 2.8, 1e-12);
  EXPECT_EQ(found[0].side(Side::bottom).status, DrawnStatus::seen);
}

TEST(Panes, ThoseThatEndApartAreOneWindowLikeOthersOfTheirColumn) {
  std::vector<FoundRectangle> found{pane({1, 1.42, 5, 6.8}), pane({1.48, 1.9, 5.4, 6.8}), pane({1, 1.9, 1, 2.8})};
  join_panes_like_others(0.04, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].side(Side::bottom).status, DrawnStatus::seen);
  EXPECT_DOUBLE_EQ(found[0].at(Side::bottom), 5);
}

TEST(Panes, ThoseThatAreLikeNothingStayAlone) {
  const std::vector<FoundRectangle> apart{pane({1, 1.42, 1, 2.1}), pane({1.48, 1.9, 1, 2.5})};
  std::vector<FoundRectangle> found = apart;
  join_panes_like_others(0.04, found);
  EXPECT_EQ(found.size(), 2u);
  found = apart;
  found.push_back(pane({3, 4.2, 1, 2.8}));  // wider
  join_panes_like_others(0.04, found);
  EXPECT_EQ(found.size(), 3u);
  found = apart;
  found.push_back(pane({3, 3.9, 1, 2.8}));
  for (const double u : {5.0, 6.0, 7.0}) found.push_back(pane({u, u + 0.42, 1, 2.1}));  // it may be two of these
  join_panes_like_others(0.04, found);
  EXPECT_EQ(found.size(), 6u);
  found = apart;
  found.push_back(pane({3, 3.9, 0.2, 5.5}));  // they are less than half of it
  join_panes_like_others(0.04, found);
  EXPECT_EQ(found.size(), 3u);
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
