// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/flat_mesh.h"

#include <cmath>

namespace ilot {
namespace {

constexpr std::uint32_t kNone = ~0u;

void add_vector(std::vector<float>& list, Vec3 v) {
  for (const double c : {v.x, v.y, v.z}) list.push_back(static_cast<float>(c));
}

// The normal of a face among the places, which may be turned against the CRS.
Vec3 placed_normal(const std::vector<Vec3>& places, const BuildingMesh& mesh, std::size_t first, std::size_t end) {
  Vec3 sum;
  for (std::size_t i = first; i < end; ++i) {
    const TriangleCorners& t = mesh.triangles[i];
    sum = sum + cross(places[t[1]] - places[t[0]], places[t[2]] - places[t[0]]);
  }
  const double length = norm(sum);
  return length > 0 ? (1 / length) * sum : Vec3{0, 0, 1};
}

}  // namespace

void add_flat(FlatMesh& flat, const Building& building, const BuildingMesh& mesh, const PlaceOf& place,
              const FaceTaker& take) {
  std::vector<Vec3> places;
  for (const Vec3& v : mesh.vertices) places.push_back(place(v));
  std::vector<std::uint32_t> number(places.size(), kNone);  // as last given: those below `before` are of other faces
  for (std::size_t first = 0, end = 0; first < mesh.triangles.size(); first = end) {
    const std::uint32_t surface = mesh.surface[first], before = flat.vertices();
    while (end < mesh.triangles.size() && mesh.surface[end] == surface) ++end;
    const Vec3 normal = placed_normal(places, mesh, first, end);
    auto& triangles = flat.triangles[static_cast<std::size_t>(building.surfaces[surface].kind)];
    for (std::size_t i = first; i < end; ++i)
      for (const std::uint32_t corner : mesh.triangles[i]) {
        if (number[corner] == kNone || number[corner] < before) {
          number[corner] = flat.vertices();
          add_vector(flat.positions, places[corner]);
          add_vector(flat.normals, normal);
        }
        triangles.push_back(number[corner]);
      }
    if (take) take(surface, before, flat.vertices());
  }
}

nlohmann::ordered_json flat_primitives(Glb& glb, const FlatMesh& flat, const nlohmann::ordered_json& attributes) {
  using Json = nlohmann::ordered_json;
  Json of_vertices{{"POSITION", glb.add_vectors(flat.positions, true)},
                   {"NORMAL", glb.add_vectors(flat.normals, false)}};
  if (attributes.is_object()) of_vertices.update(attributes);
  Json primitives = Json::array();
  for (std::size_t kind = 0; kind < flat.triangles.size(); ++kind)
    if (!flat.triangles[kind].empty())
      primitives.push_back(
          {{"attributes", of_vertices}, {"indices", glb.add_indices(flat.triangles[kind])}, {"material", kind}});
  return primitives;
}

}  // namespace ilot
