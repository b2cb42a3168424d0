// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_face.h"

#include <gtest/gtest.h>

#include "tests/support/solids.h"

namespace ilot {
namespace {

// A face on its own, metres.
struct Face {
  LatticeVertices vertices;
  FaceRings rings;
};

Face face(const std::vector<std::vector<Vec3>>& rings) {
  Face f;
  for (const auto& ring : rings) {
    f.rings.emplace_back();
    for (const Vec3& p : ring) {
      f.rings.back().push_back(static_cast<std::uint32_t>(f.vertices.points.size()));
      f.vertices.points.push_back({std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)});
    }
  }
  return f;
}

Codes face_codes(const Face& f) {
  return codes_of(validate_face(f.vertices, f.rings, {}));
}

const std::vector<Vec3> kSquare{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
const std::vector<Vec3> kInnerRing{{2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}};

std::vector<Vec3> moved(std::vector<Vec3> ring, double x, double y) {
  for (Vec3& p : ring) p = {p.x + x, p.y + y, p.z};
  return ring;
}

TEST(ValidateFace, RightFacesHaveNoFault) {
  EXPECT_EQ(face_codes(face({kSquare})), Codes{});
  EXPECT_EQ(face_codes(face({kSquare, kInnerRing})), Codes{});
  EXPECT_EQ(face_codes(face({kSquare, kInnerRing, moved(kInnerRing, 4, 0)})), Codes{});
  EXPECT_EQ(face_codes(face({{{0, 0, 0}, {3, 0, 1}, {0, 3, 7}}})), Codes{});
}

TEST(ValidateFace, Rings) {
  EXPECT_EQ(face_codes(face({{{0, 0, 0}, {1, 0, 0}}})), Codes{101});
  EXPECT_EQ(face_codes({{}, {}}), Codes{101});
  Face twice = face({kSquare});
  twice.rings[0] = {0, 1, 1, 2, 3};
  EXPECT_EQ(face_codes(twice), Codes{102});
  twice.rings[0] = {0, 1, 2, 3, 0};
  EXPECT_EQ(face_codes(twice), Codes{102}) << "the last is the first";
  EXPECT_EQ(face_codes(face({{{0, 0, 0}, {10, 10, 0}, {10, 0, 0}, {0, 10, 0}}})), Codes{104}) << "a bow tie";
  EXPECT_EQ(face_codes(face({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}})), Codes{104}) << "a triangle on a line";
  EXPECT_EQ(face_codes(face({kSquare, {{2, 2, 0}, {4, 4, 0}, {4, 2, 0}, {2, 4, 0}}})), Codes{104}) << "a hole";
}

TEST(ValidateFace, HowRingsLieToEachOther) {
  EXPECT_EQ(face_codes(face({kSquare, moved(kInnerRing, 7, 0)})), Codes{201});
  EXPECT_EQ(face_codes(face({kSquare, kInnerRing, kInnerRing})), Codes{201}) << "holes that share edges";
  EXPECT_EQ(face_codes(face({kSquare, {{0, 5, 0}, {5, 10, 0}, {10, 5, 0}, {5, 0, 0}}})), Codes{205});
  EXPECT_EQ(face_codes(face({kSquare, moved(kInnerRing, 20, 0)})), Codes{206});
  EXPECT_EQ(face_codes(face({kSquare, {{1, 1, 0}, {1, 9, 0}, {9, 9, 0}, {9, 1, 0}}, kInnerRing})), Codes{207});
  EXPECT_EQ(face_codes(face({kSquare, {kInnerRing.rbegin(), kInnerRing.rend()}})), Codes{208});
  EXPECT_EQ(face_codes(face({kSquare, {{0, 0, 0}, {2, 4, 0}, {4, 2, 0}}})), Codes{})
      << "a hole that touches in a corner";
}

TEST(ValidateFace, Planes) {
  EXPECT_EQ(face_codes(face({{{0, 0, 0}, {10, 0, 0}, {10, 10, 0.5}, {0, 10, 0}}})), Codes{203});
  EXPECT_EQ(face_codes(face({{{0, 0, 0}, {10, 0, 0}, {10, 10, 0.02}, {0, 10, 0}}})), Codes{}) << "half a centimetre";
  ValidityParams strict;
  strict.plane_distance = 0.001;
  const Face bent = face({{{0, 0, 0}, {10, 0, 0}, {10, 10, 0.02}, {0, 10, 0}}});
  EXPECT_EQ(codes_of(validate_face(bent.vertices, bent.rings, strict)), Codes{203});
}

double area(const Face& f, const std::vector<TriangleCorners>& triangles) {
  double sum = 0;
  const auto at = [&](std::uint32_t i) {
    const Index3 p = f.vertices.points[i];
    return Vec3{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  };
  for (const auto& [a, b, c] : triangles) sum += cross(at(b) - at(a), at(c) - at(a)).z / 2e12;
  return sum;
}

TEST(ValidateFace, TrianglesCoverTheFaceAndTurnAsItDoes) {
  struct Case {
    std::vector<std::vector<Vec3>> rings;
    std::size_t triangles;
    double area;
  };
  const std::vector<Vec3> corner{{0, 0, 0}, {10, 0, 0}, {10, 2, 0}, {2, 2, 0}, {2, 10, 0}, {0, 10, 0}};
  const std::vector<Vec3> dart{{0, 0, 0}, {9, 0, 0}, {3, 3, 0}, {0, 9, 0}};
  const std::vector<Case> cases{
      {{kSquare}, 2, 100}, {{kSquare, kInnerRing}, 8, 96}, {{corner}, 4, 36}, {{dart}, 2, 27}};
  for (const auto& [rings, triangles, wanted] : cases) {
    Face f = face(rings);
    const auto cut = triangulate_face(f.vertices, f.rings);
    EXPECT_EQ(cut.size(), triangles);
    EXPECT_NEAR(area(f, cut), wanted, 1e-9);
    for (auto& ring : f.rings) std::reverse(ring.begin(), ring.end());
    EXPECT_NEAR(area(f, triangulate_face(f.vertices, f.rings)), -wanted, 1e-9);
  }
}

TEST(ValidateFace, TrianglesFollowTheRing) {
  const Face f = face({kSquare});
  EXPECT_EQ(triangulate_face(f.vertices, f.rings).size(), 2u);
  const Face dart = face({{{0, 0, 0}, {9, 0, 0}, {3, 3, 0}, {0, 9, 0}}});
  EXPECT_EQ(triangulate_face(dart.vertices, dart.rings), (std::vector<TriangleCorners>{{0, 1, 2}, {0, 2, 3}}));
  const Face kite = face({{{3, 3, 0}, {0, 9, 0}, {0, 0, 0}, {9, 0, 0}}});
  EXPECT_EQ(triangulate_face(kite.vertices, kite.rings), (std::vector<TriangleCorners>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ValidateFace, MeasuresBends) {
  const Face f = face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}});
  const std::vector<TriangleCorners> flat{{0, 1, 2}}, bent{{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(least_normals_cosine(f.vertices, flat), 1);
  EXPECT_NEAR(least_normals_cosine(f.vertices, bent), 1 / std::sqrt(3.0), 1e-12);
}

}  // namespace
}  // namespace ilot
