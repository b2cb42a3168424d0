// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/plane_section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// A wall 10 wide and 4 high in the plane y = 0 with a window from 4 to 6, 1 to 3.
SectionFace wall() {
  return {{{{0, 0, 0}, {10, 0, 0}, {10, 0, 4}, {0, 0, 4}}, {{4, 0, 1}, {4, 0, 3}, {6, 0, 3}, {6, 0, 1}}}};
}

SectionPlane at_height(double z) {
  return {{0, 0, z}, {1, 0, 0}, {0, 1, 0}};
}

double length(const std::vector<FlatEdge>& edges) {
  double sum = 0;
  for (const FlatEdge& e : edges) sum += std::hypot(e.b.x - e.a.x, e.b.y - e.a.y);
  return sum;
}

TEST(PlaneSection, LeavesHolesOut) {
  const std::vector<SectionFace> faces{wall()};
  const std::vector<FlatEdge> cut = cut_faces(faces, at_height(2));
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_DOUBLE_EQ(cut[0].a.x, 0);
  EXPECT_DOUBLE_EQ(cut[0].b.x, 4);
  EXPECT_DOUBLE_EQ(cut[1].a.x, 6);
  EXPECT_DOUBLE_EQ(cut[1].b.x, 10);
  EXPECT_EQ(cut_faces(faces, at_height(0.5)).size(), 1u);
  EXPECT_TRUE(cut_faces(faces, at_height(5)).empty());
  EXPECT_TRUE(cut_faces({}, at_height(2)).empty());
}

TEST(PlaneSection, WhatLiesBeyondItsEndsIsNotCut) {
  const std::vector<SectionFace> faces{wall()};
  SectionPlane plane = at_height(2);
  plane.from = 1;
  plane.to = 7.5;
  const std::vector<FlatEdge> cut = cut_faces(faces, plane);
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_DOUBLE_EQ(cut[0].a.x, 1);
  EXPECT_DOUBLE_EQ(cut[0].b.x, 4);
  EXPECT_DOUBLE_EQ(cut[1].b.x, 7.5);
  plane.from = 10.5;
  plane.to = 12;
  EXPECT_TRUE(cut_faces(faces, plane).empty());
  SectionPlane steep{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // along y: the wall is cut at y = 0 alone
  const std::vector<SectionFace> slope{SectionFace{{{{-1, 0, 0}, {1, 0, 0}, {1, 4, 2}, {-1, 4, 2}}}}};
  steep.from = 1;
  steep.to = 3;
  const std::vector<FlatEdge> sloped = cut_faces(slope, steep);
  ASSERT_EQ(sloped.size(), 1u);
  EXPECT_DOUBLE_EQ(std::min(sloped[0].a.y, sloped[0].b.y), 0.5);
  EXPECT_DOUBLE_EQ(std::max(sloped[0].a.y, sloped[0].b.y), 1.5);
}

TEST(PlaneSection, CornersInThePlaneAreCrossedAnEvenNumberOfTimes) {
  const std::vector<SectionFace> faces{wall()};
  EXPECT_DOUBLE_EQ(length(cut_faces(faces, at_height(1))), 10);  // its corners count as above the plane
  EXPECT_DOUBLE_EQ(length(cut_faces(faces, at_height(3))), 8);
  EXPECT_TRUE(cut_faces(faces, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}).empty());  // the face's own plane
  const std::vector<SectionFace> broken{SectionFace{}, SectionFace{{{}}}, SectionFace{{{{0, 0, 0}}}}};
  EXPECT_TRUE(cut_faces(broken, at_height(0)).empty());
}

TEST(PlaneSection, ConvexFacesAreCutAsTheirEdgesSay) {
  Rng rng(7);
  for (int round = 0; round < 200; ++round) {
    const auto number = [&] { return rng.uniform() * 10 - 5; };
    const SectionFace triangle{
        {{{number(), number(), number()}, {number(), number(), number()}, {number(), number(), number()}}}};
    const std::vector<FlatEdge> cut = cut_faces(std::vector<SectionFace>{triangle}, at_height(0));
    int above = 0;
    for (const Vec3& v : triangle.rings[0]) above += v.z >= 0;
    ASSERT_EQ(cut.size(), above == 1 || above == 2 ? 1u : 0u);
  }
}

TEST(PlaneSection, StretchesBecomeChains) {
  const std::vector<FlatEdge> box{{{0, 0}, {1, 0}}, {{1, 1}, {1, 0}}, {{0, 1}, {1, 1.00001}},
                                  {{0, 1}, {0, 0}}, {{5, 5}, {6, 5}}, {{7, 7}, {7, 7}}};
  const auto chains = join_stretches(box, 1e-4);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].size(), 2u);  // the open one first
  ASSERT_EQ(chains[1].size(), 5u);
  EXPECT_EQ(chains[1].front().x, chains[1].back().x);
  EXPECT_EQ(chains[1].front().y, chains[1].back().y);
  EXPECT_TRUE(join_stretches({}, 1).empty());
}

TEST(PlaneSection, EveryStretchIsInOneChain) {
  Rng rng(11);
  for (int round = 0; round < 100; ++round) {
    std::vector<FlatEdge> edges;
    const auto corner = [&] { return FlatPoint{std::floor(rng.uniform() * 4), std::floor(rng.uniform() * 4)}; };
    for (int i = 0; i < 12; ++i) edges.push_back({corner(), corner()});
    double all = 0, joined = 0;
    for (const FlatEdge& e : edges) all += std::hypot(e.b.x - e.a.x, e.b.y - e.a.y);
    for (const auto& chain : join_stretches(edges, 1e-3))
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        joined += std::hypot(chain[i + 1].x - chain[i].x, chain[i + 1].y - chain[i].y);
    ASSERT_NEAR(joined, all, 1e-9);
  }
}

}  // namespace
}  // namespace ilot
