// SPDX-License-Identifier: Apache-2.0
#include "engine/model/polygon_model.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

// A box from the origin; faces outwards: floor, roof, then four walls.
PolygonModel box(double x, double y, double z) {
  return {"box",
          {{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}},
          {{{{0, 3, 2, 1}}, FaceKind::unknown, 0},
           {{{4, 5, 6, 7}}, FaceKind::unknown, 0},
           {{{0, 1, 5, 4}}, FaceKind::unknown, 0},
           {{{1, 2, 6, 5}}, FaceKind::unknown, 0},
           {{{2, 3, 7, 6}}, FaceKind::unknown, 0},
           {{{3, 0, 4, 7}}, FaceKind::unknown, 0}}};
}

TEST(PolygonModel, KnowsWhetherItIsClosed) {
  PolygonModel model = box(2, 3, 4);
  EXPECT_TRUE(is_closed(model));
  model.faces.pop_back();
  EXPECT_FALSE(is_closed(model));
  EXPECT_FALSE(is_closed({"none", {}, {}}));
  model = box(2, 3, 4);
  std::swap(model.faces[1].rings[0][0], model.faces[1].rings[0][2]);  // turned over: its edges run the same way
  EXPECT_FALSE(is_closed(model));
}

TEST(PolygonModel, ClosesOverVerticesAtOnePlaceAndPerShell) {
  PolygonModel model = box(2, 3, 4);
  model.vertices.push_back(model.vertices[5]);
  model.faces[1].rings[0][1] = 8;
  EXPECT_TRUE(is_closed(model));
  model.faces[1].shell = 1;
  EXPECT_FALSE(is_closed(model));
}

TEST(PolygonModel, NormalIsTwiceTheArea) {
  const PolygonModel model = box(2, 3, 4);
  EXPECT_EQ(face_normal(model, model.faces[0]).z, -12);
  EXPECT_EQ(face_normal(model, model.faces[1]).z, 12);
  EXPECT_EQ(face_normal(model, model.faces[3]).x, 24);
}

TEST(PolygonModel, FindsRoofsWhicheverWayTheyFace) {
  PolygonModel model = box(2, 3, 4);
  const std::vector<bool> wanted{false, true, false, false, false, false};
  EXPECT_EQ(roof_faces(model), wanted);
  for (PolygonFace& face : model.faces) std::reverse(face.rings[0].begin(), face.rings[0].end());
  EXPECT_EQ(roof_faces(model), wanted);
  model.faces[0].kind = FaceKind::roof;  // what is said counts
  model.faces[1].kind = FaceKind::wall;
  EXPECT_EQ(roof_faces(model), (std::vector<bool>{true, false, false, false, false, false}));
  EXPECT_EQ(roof_faces(box(2, 3, 0.05)), (std::vector<bool>{true, true, false, false, false, false}));  // all flat
}

TEST(PolygonModel, TrianglesCoverFacesWithHoles) {
  PolygonModel model{"wall",
                     {{0, 0, 0}, {0, 6, 0}, {0, 6, 6}, {0, 0, 6}, {0, 1, 1}, {0, 2, 1}, {0, 2, 3}, {0, 1, 3}},
                     {{{{0, 1, 2, 3}, {7, 6, 5, 4}}, FaceKind::wall, 0}}};
  std::vector<Triangle3> triangles;
  append_triangles(model, model.faces[0], triangles);
  double area = 0;
  for (const Triangle3& t : triangles) area += norm(cross(t.b - t.a, t.c - t.a)) / 2;
  EXPECT_NEAR(area, 36 - 2, 1e-12);
  EXPECT_EQ(triangles.size(), 8u);
}

}  // namespace
}  // namespace ilot
