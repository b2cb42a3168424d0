// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/bent_faces.h"

#include <cmath>
#include <utility>

#include "engine/products/roofs/solids/planar_pieces.h"

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

std::vector<std::vector<std::uint32_t>> divided(const LatticeVertices& vertices, const FaceRings& rings, Division how,
                                                double most_bent) {
  if (how == Division::pieces) return planar_pieces(vertices, rings, most_bent);
  std::vector<std::vector<std::uint32_t>> triangles;
  for (const TriangleCorners& corners : triangulate_face(vertices, rings))
    triangles.emplace_back(corners.begin(), corners.end());
  return triangles;
}

}  // namespace

bool divide_bent_faces(RoofSolid& solid, Division how, double most_bent) {
  const LatticeVertices vertices = lattice_of(solid);
  std::vector<BuildingSurface> surfaces;
  for (BuildingSurface& surface : solid.surfaces) {
    if (surface.kind != SurfaceKind::roof || !bent(vertices, surface.rings, most_bent)) {
      surfaces.push_back(std::move(surface));
      continue;
    }
    for (std::vector<std::uint32_t>& ring : divided(vertices, surface.rings, how, most_bent)) {
      BuildingSurface piece;
      piece.plane_id = surface.plane_id;
      piece.rings.push_back(std::move(ring));
      surfaces.push_back(std::move(piece));
    }
  }
  const bool changed = surfaces.size() != solid.surfaces.size();
  solid.surfaces = std::move(surfaces);
  return changed;
}

}  // namespace ilot
