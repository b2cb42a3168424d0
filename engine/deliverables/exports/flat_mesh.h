// SPDX-License-Identifier: Apache-2.0
// Triangles as graphics cards want them: float32 near an anchor, each face with its own vertices and its normal.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/deliverables/exports/building_mesh.h"
#include "engine/deliverables/exports/glb.h"

namespace ilot {

struct FlatMesh {
  std::vector<float> positions, normals;                // x y z each
  std::array<std::vector<std::uint32_t>, 3> triangles;  // by SurfaceKind: numbers of vertices

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(positions.size() / 3); }
};

// Brings a place of the CRS into metres near zero. Within 4 km of zero float32 rounds by less than 0.25 mm.
using PlaceOf = std::function<Vec3(Vec3)>;

// Adds a building. Faces keep their order within their kind.
// `take` is called after each face with its number and those of its first vertex and the one after its last.
using FaceTaker = std::function<void(std::uint32_t surface, std::uint32_t first, std::uint32_t end)>;
void add_flat(FlatMesh& flat, const Building& building, const BuildingMesh& mesh, const PlaceOf& place,
              const FaceTaker& take = {});

// Adds its arrays to the file and returns the primitives of a mesh, a kind of faces each, with `attributes` beside
// POSITION and NORMAL.
nlohmann::ordered_json flat_primitives(Glb& glb, const FlatMesh& flat, const nlohmann::ordered_json& attributes = {});

}  // namespace ilot
