// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/bent_faces.h"

#include <cmath>
#include <utility>

#include "engine/model/face_triangles.h"

namespace ilot {
namespace {

// Derived: x and y of a solid are whole millimetres, z whole tenths of one.
constexpr double kStep = 1e-4;  // metres

LatticeVertices lattice_of(const RoofSolid& solid) {
  LatticeVertices lattice{{}, kStep};
  for (const Vec3& v : solid.vertices)
    lattice.points.push_back({std::llround(v.x / kStep), std::llround(v.y / kStep), std::llround(v.z / kStep)});
  return lattice;
}

bool bent(const LatticeVertices& vertices, const FaceRings& rings, double most_bent) {
  return !is_one_triangle(rings) && farthest_from(plane_of(vertices, rings), vertices, rings) > most_bent;
}

}  // namespace

bool divide_bent_faces(RoofSolid& solid, double most_bent) {
  const LatticeVertices vertices = lattice_of(solid);
  std::vector<BuildingSurface> surfaces;
  for (BuildingSurface& surface : solid.surfaces) {
    if (surface.kind != SurfaceKind::roof || !bent(vertices, surface.rings, most_bent)) {
      surfaces.push_back(std::move(surface));
      continue;
    }
    for (const TriangleCorners& corners : triangulate_face(vertices, surface.rings)) {
      BuildingSurface triangle;
      triangle.plane_id = surface.plane_id;
      triangle.rings.push_back({corners.begin(), corners.end()});
      surfaces.push_back(std::move(triangle));
    }
  }
  const bool divided = surfaces.size() != solid.surfaces.size();
  solid.surfaces = std::move(surfaces);
  return divided;
}

}  // namespace ilot
