// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/bent_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/products/roofs/solids/planar_pieces.h"
#include "engine/validity/validity.h"
#include "kernels/core/rng.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::rectangle;

RoofPlane sloping(double gx, double gy, double c) {
  RoofPlane p;
  p.gx = gx;
  p.gy = gy;
  p.c = c;
  return p;
}

std::vector<int> faults_of(const RoofSolid& solid, double planar) {
  Building b;
  b.id = "solid";
  b.vertices = solid.vertices;
  b.surfaces = solid.surfaces;
  ValidityParams params;
  params.plane_distance = planar;
  return codes_of(validate_building(b, {}, 0.0001, params));
}

// A saddle roof whose planes miss each other by `apart` at one end of the ridge.
RoofSolid saddle(double apart) {
  const std::vector<FlatEdge> ridge{{{-1, 3}, {11, 3}}};
  const std::vector<RoofPlane> planes{sloping(0, 0.5, 4), sloping(apart / 10, -0.5, 7)};
  return extrude_roof(part(rectangle(10, 6), ridge), planes, 0);
}

TEST(BentFaces, PlanarFacesStay) {
  RoofSolid solid = saddle(0);
  const std::size_t surfaces = solid.surfaces.size();
  EXPECT_FALSE(divide_bent_faces(solid, Division::pieces));
  EXPECT_EQ(solid.surfaces.size(), surfaces);
}

// Heights at the end of the ridge are within 1 cm, so they are one, and both faces bend.
TEST(BentFaces, TrianglesOfAFaceThatSharesItsVertices) {
  RoofSolid solid = saddle(0.009);
  const std::vector<int> bent = faults_of(solid, 0.001);
  ASSERT_FALSE(bent.empty());
  EXPECT_EQ(bent[0], 203);
  const std::size_t vertices = solid.vertices.size();
  EXPECT_TRUE(divide_bent_faces(solid, Division::triangles));
  EXPECT_TRUE(faults_of(solid, 0.001).empty());
  EXPECT_EQ(solid.vertices.size(), vertices);
  for (const BuildingSurface& s : solid.surfaces) EXPECT_EQ(s.plane_id > 0, s.kind == SurfaceKind::roof);
}

// One corner of a face of many that is off costs one triangle.
TEST(BentFaces, OneCornerThatIsOffIsCutOff) {
  std::vector<Index3> points;
  FaceRings rings(1);
  for (int i = 0; i < 12; ++i) {
    const double turn = i * M_PI / 6;
    points.push_back({std::llround(50000 * std::cos(turn)), std::llround(50000 * std::sin(turn)), i == 5 ? 20 : 0});
    rings[0].push_back(static_cast<std::uint32_t>(i));
  }
  const auto pieces = planar_pieces({points, 1e-4}, rings, kMostBent);
  ASSERT_GE(pieces.size(), 2u);
  EXPECT_LE(pieces.size(), 4u);
  EXPECT_GE(pieces[0].size(), 9u);
  std::size_t corners = 0;
  for (const auto& ring : pieces) corners += ring.size() - 2;
  EXPECT_EQ(corners, 10u);  // as many triangles as the face has
}

// Roofs of many faces whose heights at common corners differ at random.
TEST(BentFaces, RandomRoofsBecomePlanar) {
  Rng rng(11);
  int divided = 0;
  for (int n = 0; n < 40; ++n) {
    std::vector<FlatEdge> lines;
    for (int k = 1; k < 4; ++k) {
      lines.push_back({{-1, 2.0 * k}, {13, 2.0 * k + 0.4 * rng.uniform()}});
      lines.push_back({{3.0 * k, -1}, {3.0 * k + 0.5 * rng.uniform(), 9}});
    }
    const Partition faces = part(rectangle(12, 8), lines);
    ASSERT_GE(faces.regions, 12u);
    std::vector<RoofPlane> planes;
    for (std::uint32_t f = 0; f < faces.regions; ++f)
      planes.push_back(sloping(0.00004 * rng.uniform(), 0.00004 * rng.uniform(), 5 + 0.009 * rng.uniform()));
    RoofSolid solid = extrude_roof(faces, planes, 0);
    ASSERT_TRUE(faults_of(solid, 0.01).empty());
    for (const Division how : {Division::pieces, Division::triangles}) {
      RoofSolid planar = solid;
      divided += divide_bent_faces(planar, how, 0.0003);
      EXPECT_TRUE(faults_of(planar, 0.0004).empty()) << n;
    }
  }
  EXPECT_GT(divided, 40);
}

}  // namespace
}  // namespace ilot
