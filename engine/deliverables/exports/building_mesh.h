// SPDX-License-Identifier: Apache-2.0
// A building as triangles, for formats that have no polygons with holes.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/building.h"
#include "kernels/core/types.h"
#include "kernels/meshes/manifold.h"

namespace ilot {

// The triangles of a closed building are closed too: they share the numbers of their vertices.
struct BuildingMesh {
  std::vector<Vec3> vertices;              // CRS; those that faces use, in the order of their first use
  std::vector<TriangleCorners> triangles;  // counter-clockwise seen from outside
  std::vector<std::uint32_t> surface;      // of each triangle: its number in Building::surfaces, rising
};

// Divides the faces by triangulate_face(), as the test of the validity of solids does. O(n log n) in corners.
BuildingMesh building_mesh(const Building& building);

}  // namespace ilot
