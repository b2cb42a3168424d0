// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_shell.h"

#include <gtest/gtest.h>

#include "tests/support/solids.h"

namespace ilot {
namespace {

const Shape kShellCube = box({0, 0, 0}, {1, 1, 1});

Shape without_face(Shape s, std::size_t face) {
  s.faces.erase(s.faces.begin() + static_cast<std::ptrdiff_t>(face));
  return s;
}

TEST(ValidateShell, LatticesFitTheirObjects) {
  EXPECT_EQ(lattice_of(kShellCube.vertices).step, 1e-6);
  const ValidityLattice wide = lattice_of(std::vector<Vec3>{{-1e6, 5, 0}, {1e6, 9, 3}});
  EXPECT_NEAR(wide.step, 1e-4, 1e-18);
  EXPECT_EQ(wide.origin.x, -1e6);
  EXPECT_EQ(wide.origin.y, 5);
  EXPECT_EQ(lattice_of({}).step, 1e-6);
}

TEST(ValidateShell, FewFaces) {
  EXPECT_EQ(codes(Shape{kShellCube.vertices, {kShellCube.faces[0], kShellCube.faces[1]}}), Codes{301});
}

TEST(ValidateShell, Holes) {
  EXPECT_EQ(codes(without_face(kShellCube, 5)), Codes{302});
}

TEST(ValidateShell, NoManifolds) {
  Shape inner_wall = kShellCube;
  inner_wall.faces.push_back({{0, 2, 6, 4}});  // a third and a fourth face at two edges
  EXPECT_EQ(codes(inner_wall), Codes{303});
  Shape tip = joined(kShellCube, box({1, 1, 1}, {2, 2, 2}));  // two cubes that touch in a corner
  EXPECT_EQ(codes(tip), Codes{303});
  EXPECT_EQ(codes(joined(kShellCube, box({1, 1, 0}, {2, 2, 1}))), Codes{303}) << "two cubes that touch in an edge";
}

TEST(ValidateShell, Pieces) {
  EXPECT_EQ(codes(joined(kShellCube, box({5, 5, 5}, {6, 6, 6}))), Codes{305});
  EXPECT_EQ(codes(joined(without_face(kShellCube, 1), box({5, 5, 5}, {6, 6, 6}))), Codes{305}) << "before holes";
}

TEST(ValidateShell, FacesThatMeet) {
  Shape pyramid = kShellCube;  // the top becomes a pyramid whose tip comes out of the floor
  pyramid.vertices.push_back({0.5, 0.5, -1});
  pyramid.faces.erase(pyramid.faces.begin() + 1);
  for (const auto& [a, b] : {std::pair(4u, 5u), {5u, 6u}, {6u, 7u}, {7u, 4u}}) pyramid.faces.push_back({{a, b, 8}});
  EXPECT_EQ(codes(pyramid), Codes{306});
  pyramid.vertices.back().z = 0;
  EXPECT_EQ(codes(pyramid), Codes{306}) << "touching is meeting";
  pyramid.vertices.back().z = 0.001;
  EXPECT_EQ(codes(pyramid), Codes{});
}

TEST(ValidateShell, FacesTheWrongWayRound) {
  Shape s = kShellCube;
  std::swap(s.faces[3][0][0], s.faces[3][0][2]);
  EXPECT_EQ(codes(s), Codes{307});
}

TEST(ValidateShell, FoldsWithinTolerance) {
  Shape s = box({0, 0, 0}, {10, 10, 3});  // a roof with a fold 2 mm deep and 4 mm wide along its middle
  s.vertices.insert(s.vertices.end(),
                    {{4.998, 0, 3}, {5, 0, 2.998}, {5.002, 0, 3}, {4.998, 10, 3}, {5, 10, 2.998}, {5.002, 10, 3}});
  s.faces[1] = {{4, 8, 9, 10, 5, 6, 13, 12, 11, 7}};
  s.faces[2] = {{0, 1, 5, 10, 9, 8, 4}};
  s.faces[4] = {{2, 3, 7, 11, 12, 13, 6}};
  EXPECT_EQ(codes(s), Codes{204});
  ValidityParams loose;
  loose.plane_normals_deg = 60;
  EXPECT_EQ(codes_of(validate_object(object_of(s), loose)), Codes{});
}

TEST(ValidateShell, NearVerticesAreOne) {
  Shape s = kShellCube;
  s.vertices.push_back({1, 1, 1.0005});
  s.faces[3] = {{1, 2, 8, 5}};
  EXPECT_EQ(codes(s), Codes{});
  s.vertices.back().z = 1.002;
  EXPECT_NE(codes(s), Codes{});
  ValidityParams wide;
  wide.snap = 0.01;
  EXPECT_EQ(codes_of(validate_object(object_of(s), wide)), Codes{});
}

TEST(ValidateShell, SurfacesAskForLess) {
  const Shape open = without_face(kShellCube, 5);
  EXPECT_EQ(codes(open, PrimitiveKind::composite_surface), Codes{});
  EXPECT_EQ(codes(open, PrimitiveKind::multi_surface), Codes{});
  const Shape apart = joined(open, box({5, 5, 5}, {6, 6, 6}));
  EXPECT_EQ(codes(apart, PrimitiveKind::composite_surface), Codes{305});
  EXPECT_EQ(codes(apart, PrimitiveKind::multi_surface), Codes{});
  // Two squares with one common corner.
  const Shape touching{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                       {{{0, 1, 2, 3}}, {{2, 4, 5, 6}}}};
  EXPECT_EQ(codes(touching, PrimitiveKind::composite_surface), Codes{303});
}

}  // namespace
}  // namespace ilot
