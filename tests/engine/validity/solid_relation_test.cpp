// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/solid_relation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/solids.h"

namespace ilot {
namespace {

SolidBoundary boundary(Vec3 low, Vec3 high) {
  const Shape s = box(low, high);
  SolidBoundary b;
  for (const Vec3& v : s.vertices)
    b.vertices.push_back({std::llround(v.x * 1e6), std::llround(v.y * 1e6), std::llround(v.z * 1e6)});
  for (const FaceRings& f : s.faces) {
    b.triangles.push_back({f[0][0], f[0][1], f[0][2]});
    b.triangles.push_back({f[0][0], f[0][2], f[0][3]});
  }
  return b;
}

const SolidBoundary kBox = boundary({0, 0, 0}, {4, 4, 4});

SolidRelation with(Vec3 low, Vec3 high) {
  return relate_solids(kBox, boundary(low, high));
}

TEST(SolidRelation, Apart) {
  const SolidRelation r = with({9, 0, 0}, {10, 1, 1});
  EXPECT_FALSE(r.interiors_overlap());
  EXPECT_TRUE(r.a_outside_b && r.b_outside_a);
  EXPECT_FALSE(r.share_opposite || r.a_inside_b || r.b_inside_a);
}

TEST(SolidRelation, TheSameWhateverTheTriangles) {
  SolidBoundary other = kBox;
  other.triangles[0] = {3, 2, 1}, other.triangles[1] = {3, 1, 0};  // the other diagonal
  EXPECT_TRUE(relate_solids(kBox, other).equal());
  EXPECT_TRUE(relate_solids(kBox, other).interiors_overlap());
}

TEST(SolidRelation, OneWithinTheOther) {
  const SolidRelation r = with({1, 1, 1}, {2, 2, 2});
  EXPECT_TRUE(r.interiors_overlap() && r.b_inside_a && r.a_outside_b);
  EXPECT_FALSE(r.b_outside_a || r.a_inside_b || r.share_same || r.share_opposite);
}

TEST(SolidRelation, Crossing) {
  const SolidRelation r = with({3, 1, 1}, {6, 2, 2});
  EXPECT_TRUE(r.interiors_overlap() && r.b_inside_a && r.b_outside_a && r.a_outside_b && r.a_inside_b);
}

TEST(SolidRelation, CrossingWithCoplanarFaces) {
  const SolidRelation r = with({2, 0, 0}, {6, 4, 4});
  EXPECT_TRUE(r.interiors_overlap() && r.share_same);
  EXPECT_FALSE(r.equal());
}

TEST(SolidRelation, SideBySide) {
  const SolidRelation wall = with({4, 1, 1}, {6, 9, 2});
  EXPECT_TRUE(wall.share_opposite);
  EXPECT_FALSE(wall.interiors_overlap());
  const SolidRelation edge = with({4, 4, 0}, {6, 6, 4});
  EXPECT_FALSE(edge.share_opposite || edge.interiors_overlap());
}

TEST(SolidRelation, DoesNotDependOnWhereItHappens) {
  for (const double shift : {0.0, 0.1234567, 312.5}) {
    const SolidBoundary a = boundary({shift, shift, shift}, {shift + 4, shift + 3, shift + 2});
    const SolidBoundary b = boundary({shift + 4, shift + 1, shift}, {shift + 5, shift + 2, shift + 2});
    EXPECT_TRUE(relate_solids(a, b).share_opposite);
    EXPECT_FALSE(relate_solids(a, b).interiors_overlap());
  }
}

}  // namespace
}  // namespace ilot
