// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/facade_solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/validity/validate_models.h"
#include "kernels/core/portable_math.h"
#include "tests/support/facades.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

// A window 0.28 behind the wall, a sill 0.09 before it (its ring is its front), an arched door.
Facade solid_facade() {
  FacadeElement window = drawn("window", wall_rectangle(1, 2, 2, 4));
  window.depth_m = -0.28;
  FacadeElement sill = drawn("sill", wall_rectangle(0.9, 1.9, 2.1, 2, -0.09));
  sill.depth_m = 0.09;
  FacadeElement door = drawn("door", {{4, 0, 0}, {6, 0, 0}});
  for (int a = 0; a <= 180; a += 5) door.ring.push_back({5 + cos_degrees(a), 0, 2 + cos_degrees(a - 90.0)});
  door.arcs = {{{5, 0, 2}, 1, 0, 180}};
  door.depth_m = -0.5;
  return facade_of({window, sill, door});
}

double volume(const FacadeSolid& solid) {
  double sum = 0;
  for (const auto& face : solid.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      sum += dot(solid.vertices[face[0]], cross(solid.vertices[face[i]], solid.vertices[face[i + 1]])) / 6;
  return sum;
}

TEST(FacadeSolids, SweepsOutAndIn) {
  const std::vector<FacadeSolid> solids = facade_solids(solid_facade());
  ASSERT_EQ(solids.size(), 3u);
  EXPECT_NEAR(volume(solids[0]), 1 * 2 * 0.28, 1e-9);  // positive: faces turn outwards
  for (const Vec3& v : solids[0].vertices) EXPECT_TRUE(std::abs(v.y) < 1e-9 || std::abs(v.y - 0.28) < 1e-9);
  EXPECT_NEAR(volume(solids[1]), 1.2 * 0.1 * 0.09, 1e-9);
  for (const Vec3& v : solids[1].vertices) EXPECT_TRUE(std::abs(v.y) < 1e-9 || std::abs(v.y + 0.09) < 1e-9);
  EXPECT_NEAR(volume(solids[2]), 0.5 * (4 + 1.5708), 1e-2);
}

// A bay: 4 m at the wall, 2 m at its front.
FacadeElement a_bay() {
  FacadeElement bay = drawn("protrusion", wall_rectangle(0, 0, 4, 2));
  bay.depth_m = 1;
  bay.body.closed = true;
  bay.body.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 0, 2}, {0, 0, 2}, {1, -1, 0}, {3, -1, 0}, {3, -1, 2}, {1, -1, 2}};
  bay.body.faces = {{4, 5, 6, 7}, {3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return bay;
}

TEST(FacadeSolids, ABodyStandsForItself) {
  FacadeElement flat = a_bay();
  flat.body.vertices[5] = flat.body.vertices[4];  // no body after all: its outline is swept
  const auto solids = facade_solids(facade_of({a_bay(), flat}));
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_NEAR(volume(solids[0]), 6, 1e-9);
  EXPECT_NEAR(volume(solids[1]), 8, 1e-9);
}

TEST(FacadeSolids, IrregularitiesAreMeshesAndNoSolids) {
  FacadeElement bulge = drawn("bulge", wall_rectangle(0, 0, 1, 1));
  bulge.region = FacadeRegion::irregularity;
  bulge.depth_m = 0.04;
  bulge.body.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, -0.04, 1}};
  bulge.body.faces = {{0, 1, 2}};
  const Facade facade = facade_of({bulge, a_bay()});
  ASSERT_EQ(facade_solids(facade).size(), 1u);
  EXPECT_EQ(facade_solids(facade)[0].element, 2u);
  const auto meshes = facade_meshes(facade);
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].element, 1u);
  EXPECT_EQ(meshes[0].faces.size(), 1u);
  EXPECT_NE(solids_obj(meshes).find("o element-1-bulge\n"), std::string::npos);
}

TEST(FacadeSolids, AreValidByOurOwnRules) {
  const TemporaryFolder folder;
  Facade facade = solid_facade();
  facade.origin = {651000.3, 6861000.7, 35};
  const double s = std::sqrt(0.5);
  facade.right = {s, s, 0};
  facade.out = {s, -s, 0};
  for (FacadeElement& e : facade.elements) {
    for (Vec3& p : e.ring) p = facade.origin + p.x * facade.right + (-p.y) * facade.out + p.z * facade.up;
    for (FacadeArc& a : e.arcs) a.centre = facade.origin + a.centre.x * facade.right + a.centre.z * facade.up;
  }
  const auto file = folder.put("a.obj", solids_obj(facade_solids(facade)));
  std::string faults;
  const ModelsValidity validity = validate_models(file, [&](const ObjectValidity& found) {
    for (const Fault& fault : found.faults) faults += std::to_string(fault.code) + " ";
  });
  EXPECT_TRUE(validity.valid()) << faults;
  EXPECT_EQ(validity.objects, 3u);
}

TEST(FacadeSolids, StlIsClosedEdgeByEdge) {
  const std::string stl = solids_stl(facade_solids(solid_facade()));
  std::map<std::pair<std::string, std::string>, int> edges;
  std::vector<std::string> corners;
  std::size_t facets = 0;
  for (std::size_t at = stl.find("vertex "); at != std::string::npos; at = stl.find("vertex ", at + 1)) {
    corners.push_back(stl.substr(at, stl.find('\n', at) - at));
    if (corners.size() < 3) continue;
    ++facets;
    for (std::size_t i = 0; i < 3; ++i) ++edges[{corners[i], corners[(i + 1) % 3]}];
    corners.clear();
  }
  EXPECT_GT(facets, 100u);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

TEST(FacadeSolids, WhatIsNoSolidIsLeftOut) {
  FacadeElement flat = drawn("window", wall_rectangle(1, 2, 2, 4));
  FacadeElement bow = drawn("stone", {{0, 0, 0}, {1, 0, 1}, {1, 0, 0}, {0, 0, 1}});
  bow.depth_m = 0.1;
  FacadeElement hidden = drawn("window", wall_rectangle(1, 2, 2, 4), DrawnStatus::occluded);
  hidden.depth_m = -0.2;
  FacadeElement far = drawn("stone", wall_rectangle(-1e300, 0, 1e300, 1));
  far.depth_m = 0.1;
  EXPECT_TRUE(facade_solids(facade_of({flat, bow, hidden, far})).empty());
  EXPECT_EQ(solids_obj({}), "");
  FacadeElement named = drawn("a b\nf 1 2 3", wall_rectangle(1, 2, 2, 4));
  named.depth_m = 1;
  EXPECT_EQ(solids_obj(facade_solids(facade_of({named}))).substr(0, 24), "o element-1-a_b_f_1_2_3\n");
}

}  // namespace
}  // namespace ilot
