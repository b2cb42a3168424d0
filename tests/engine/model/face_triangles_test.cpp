// SPDX-License-Identifier: Apache-2.0
#include "engine/model/face_triangles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/building_geometry.h"
#include "tests/support/buildings.h"

namespace ilot {
namespace {

LatticeVertices vertices_of(const Building& building, double step) {
  LatticeVertices vertices;
  vertices.step = step;
  for (const Vec3& v : building.vertices)
    vertices.points.push_back({std::llround(v.x / step), std::llround(v.y / step), std::llround(v.z / step)});
  return vertices;
}

TEST(FaceTriangles, TurnAsTheirFaceAndCoverIt) {
  const Building court = court_house("a");
  for (const BuildingSurface& s : court.surfaces) {
    double area = 0;
    for (const auto& [a, b, c] : triangulate_face(vertices_of(court, 0.001), s.rings)) {
      const SurfaceShape part = surface_shape(court, {s.kind, 0, {{a, b, c}}}, 1);
      EXPECT_NEAR(part.slope_deg, surface_shape(court, s, 1).slope_deg, 1e-9);
      area += part.area_m2;
    }
    EXPECT_NEAR(area, surface_shape(court, s, 1).area_m2, 1e-9);
  }
}

// A hole of a nearly flat face whose corner is beside the diagonal of the outer ring: no triangle may be so thin that
// it passes the corner within what the face is out of its plane.
TEST(FaceTriangles, AreAsThickAsTheyCanBe) {
  LatticeVertices v;
  v.step = 0.001;
  v.points = {{0, 0, 0},       {20000, 0, 0},    {20000, 20000, 0}, {0, 20000, 0},
              {9000, 9010, 0}, {9000, 12000, 0}, {12000, 12000, 0}};
  const auto triangles = triangulate_face(v, {{0, 1, 2, 3}, {4, 5, 6}});
  ASSERT_EQ(triangles.size(), 7u);
  for (const TriangleCorners& t : triangles) {
    const bool long_diagonal = std::count(t.begin(), t.end(), 0u) + std::count(t.begin(), t.end(), 2u) == 2;
    EXPECT_FALSE(long_diagonal) << "it would pass the hole's corner by 7 mm";
  }
}

}  // namespace
}  // namespace ilot
