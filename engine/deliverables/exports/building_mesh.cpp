// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/building_mesh.h"

#include <cmath>

#include "engine/model/face_triangles.h"

namespace ilot {
namespace {

constexpr double kStep = 1e-4;  // CRS units. Derived: the step of coordinates in roofs.city.jsonl

LatticeVertices on_lattice(const Building& building) {
  LatticeVertices lattice;
  lattice.step = kStep;
  if (building.vertices.empty()) return lattice;
  const Vec3 first = building.vertices[0];
  for (const Vec3& v : building.vertices)
    lattice.points.push_back({std::llround((v.x - first.x) / kStep), std::llround((v.y - first.y) / kStep),
                              std::llround((v.z - first.z) / kStep)});
  return lattice;
}

}  // namespace

BuildingMesh building_mesh(const Building& building) {
  constexpr std::uint32_t kNone = ~0u;
  const LatticeVertices lattice = on_lattice(building);
  std::vector<std::uint32_t> number(building.vertices.size(), kNone);
  BuildingMesh mesh;
  for (std::size_t s = 0; s < building.surfaces.size(); ++s) {
    for (TriangleCorners corners : triangulate_face(lattice, building.surfaces[s].rings)) {
      for (auto& corner : corners) {
        if (number[corner] == kNone) {
          number[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
          mesh.vertices.push_back(building.vertices[corner]);
        }
        corner = number[corner];
      }
      mesh.triangles.push_back(corners);
      mesh.surface.push_back(static_cast<std::uint32_t>(s));
    }
  }
  return mesh;
}

}  // namespace ilot
