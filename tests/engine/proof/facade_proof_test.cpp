// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/facade_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/facades.h"

namespace ilot {
namespace {

constexpr double kLeft = 1, kRight = 2, kBottom = 1, kTop = 2.4, kBack = -0.2;  // of the true window
constexpr double kStep = 0.01;

// A wall of 4 by 3 metres with one window, its left edge drawn off by so much.
Facade a_wall(double left_off = 0) {
  FacadeElement outline = drawn("outline", wall_rectangle(0, 0, 4, 3));
  outline.region = FacadeRegion::facade;
  outline.width_error_m = 0.02;
  outline.height_error_m = 0.01;
  FacadeElement window = drawn("window", wall_rectangle(kLeft + left_off, kBottom, kRight, kTop));
  window.edges.assign(4, {DrawnStatus::seen, 7, 0.5, 0.004, 0});
  window.depth_m = kBack;
  return facade_of({outline, window});
}

// Every kStep a point of the true wall, of the window's reveals at left and right, and of its pane.
std::vector<Vec3> points_of_wall() {
  std::vector<Vec3> points;
  const auto at = [](int i) { return (i + 0.5) * kStep; };
  for (int i = 0; i < 400; ++i)
    for (int k = 0; k < 300; ++k) {
      const double u = at(i), v = at(k);
      const bool hole = u > kLeft && u < kRight && v > kBottom && v < kTop;
      points.push_back({u, v, hole ? kBack : 0});
    }
  for (int k = 0; k < 140; ++k)
    for (int i = 0; i < 20; ++i)
      for (const double u : {kLeft, kRight}) points.push_back({u, kBottom + at(k), -at(i)});
  return points;
}

Facade proved(Facade facade, const std::vector<Vec3>& points) {
  const FacadeProof proof(facade);
  ProofTally tally = proof.no_points();
  proof.add(points, tally);
  proof.write(tally, facade);
  return facade;
}

const FacadeFace& face_of(const FacadeElement& e, const std::string& name) {
  const auto at = std::find_if(e.faces.begin(), e.faces.end(), [&](const FacadeFace& f) { return f.name == name; });
  EXPECT_NE(at, e.faces.end()) << name;
  return *at;
}

TEST(FacadeProof, ExactPointsSupportWhatIsDrawnWhereItIs) {
  const Facade facade = proved(a_wall(), points_of_wall());
  const FacadeElement &wall = facade.elements[0], &window = facade.elements[1];
  EXPECT_EQ(face_of(wall, "front").points, 400u * 300 - 100 * 140);
  EXPECT_EQ(face_of(wall, "front").rms_m, 0);
  EXPECT_EQ(face_of(window, "front").points, 100u * 140);
  EXPECT_EQ(face_of(window, "left").points, 20u * 140);
  EXPECT_EQ(face_of(window, "left").rms_m, 0);
  EXPECT_EQ(face_of(window, "top").points, 0u) << "no station saw the soffit";
  // Three columns of the wall and three rows of the reveal lie within 3 cm; at the corners some of the wall below.
  const FacadeEdge& left = window.edges[3];
  EXPECT_GE(left.points, 6u * 140);
  EXPECT_LE(left.points, 6u * 140 + 40);
  EXPECT_EQ(left.rms_m, 0);
  EXPECT_LT(window.edges[2].points, 3u * 100 + 60) << "the wall alone tells the top";
  EXPECT_GE(window.edges[2].points, 3u * 100);
  for (const FacadeEdge& e : window.edges) EXPECT_EQ(e.covered_share, 1);
  ASSERT_EQ(wall.edges.size(), 4u) << "outlines get edges";
  EXPECT_GE(wall.edges[0].points, 3u * 400);
  EXPECT_EQ(wall.edges[0].error_m, 0.01);
  EXPECT_EQ(wall.edges[1].error_m, 0.02);
}

TEST(FacadeProof, AnEdgeAtTheWrongPlaceHasPointsOffItsSurfaces) {
  // Drawn 1 cm too far in: its reveal is 1 cm from the points. Too far out: these are, and those of the wall float.
  for (const double off : {0.01, -0.01}) {
    const Facade facade = proved(a_wall(off), points_of_wall());
    const FacadeElement& window = facade.elements[1];
    EXPECT_NEAR(face_of(window, "left").rms_m, 0.01, 0.0005) << off;
    EXPECT_GT(window.edges[3].rms_m, 0.004) << off;
    EXPECT_LT(window.edges[1].rms_m, 1e-9) << "the right edge is where it should be";
    EXPECT_EQ(face_of(window, "right").rms_m, 0) << off;
  }
}

TEST(FacadeProof, HalfAnEdgeIsCovered) {
  std::vector<Vec3> points = points_of_wall();
  std::erase_if(points, [](Vec3 p) { return p.x < 1.5 && p.y > 1.7; });  // the upper half of the left jamb
  const Facade facade = proved(a_wall(), points);
  EXPECT_NEAR(facade.elements[1].edges[3].covered_share, 0.5, 0.04);
  EXPECT_NEAR(facade.elements[1].edges[2].covered_share, 0.5, 0.05);
  EXPECT_EQ(facade.elements[1].edges[1].covered_share, 1);
}

TEST(FacadeProof, AnEdgeDrawnOnNothingHasNoPoints) {
  Facade facade = a_wall();
  facade.elements.push_back(drawn("window", wall_rectangle(4.5, 1, 5.5, 2)));
  facade.elements[2].edges.assign(4, {DrawnStatus::seen, 7, 0.5, 0.004, 0});
  facade = proved(facade, points_of_wall());
  for (const FacadeEdge& e : facade.elements[2].edges) EXPECT_EQ(e.points, 0u);
  EXPECT_TRUE(facade.elements[2].faces.empty());
}

TEST(FacadeProof, OrderAndPiecesDoNotShow) {
  std::vector<Vec3> points = points_of_wall();
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z += 1e-4 * static_cast<double>(i % 17);
  const Facade whole = proved(a_wall(), points);
  Facade pieces = a_wall();
  const FacadeProof proof(pieces);
  std::reverse(points.begin(), points.end());
  ProofTally tally = proof.no_points();
  for (std::size_t i = 0; i < points.size(); i += 1000) {
    ProofTally part = proof.no_points();
    proof.add(std::span(points).subspan(i, std::min<std::size_t>(1000, points.size() - i)), part);
    tally.add(part);
  }
  proof.write(tally, pieces);
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(pieces.elements[e].edges[k].points, whole.elements[e].edges[k].points);
      EXPECT_EQ(pieces.elements[e].edges[k].rms_m, whole.elements[e].edges[k].rms_m);
      EXPECT_GT(whole.elements[e].edges[k].rms_m, 0);
    }
}

TEST(FacadeProof, ASillIsNotTheWindowAboveIt) {
  Facade facade = a_wall();
  FacadeElement sill = drawn("sill", wall_rectangle(0.9, 0.85, 2.1, 1, -0.1));
  sill.edges.assign(4, {});
  sill.depth_m = 0.1;
  facade.elements.push_back(sill);
  facade.elements[2].id = 3;
  std::vector<Vec3> points;  // its top and front near the window's bottom edge
  for (int i = 0; i < 100; ++i)
    points.push_back({1.005 + 0.01 * i, 1, 0.005}), points.push_back({1.005 + 0.01 * i, 0.99, 0.1});
  facade = proved(facade, points);
  EXPECT_EQ(facade.elements[1].edges[0].points, 0u) << "the bottom is hidden behind the sill";
  EXPECT_EQ(face_of(facade.elements[2], "top").points, 100u);
  EXPECT_EQ(face_of(facade.elements[2], "front").points, 100u);
  EXPECT_EQ(facade.elements[2].edges[2].points, 100u);
}

TEST(FacadeProof, NoWallNoFaceNoPoint) {
  Facade facade = facade_of({});
  facade = proved(facade, {{0, 0, 0}, {1, 1, 1}});
  EXPECT_TRUE(facade.elements.empty());
}

}  // namespace
}  // namespace ilot
