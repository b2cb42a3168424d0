// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district_model.h"

#include <algorithm>
#include <array>
#include <string>

#include "scan/scanners/scan_record.h"

namespace ilot::scan {
namespace {

const char* name_of(RoofShape shape) {
  constexpr std::array kNames{"flat", "gable", "hip"};
  return kNames[static_cast<std::size_t>(shape)];
}

// Adds vertices for each ring. The writer unites equal vertices.
void add_surface(Building& model, SurfaceKind kind, std::uint32_t plane, const std::vector<Vec3>& ring) {
  BuildingSurface surface{kind, plane, {{}}};
  for (Vec3 p : ring) {
    surface.rings[0].push_back(static_cast<std::uint32_t>(model.vertices.size()));
    model.vertices.push_back(p + kSceneOrigin);
  }
  model.surfaces.push_back(std::move(surface));
}

}  // namespace

Building house_model(const Cell& cell, std::uint32_t house, std::uint32_t first_plane, std::uint32_t first_building) {
  const HouseForm& form = cell.houses[house];
  const ConvexSolid& solid = cell.solids[house];
  Building model;
  model.id = "building-" + std::to_string(first_building + house);
  std::vector<Vec3> floor;
  std::int64_t roofs = 0;
  double ridge = form.eave, ground = form.eave;
  for (std::uint32_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f) {
    const Face& face = cell.faces[f];
    const bool roof = face.surface == Surface::roof;
    add_surface(model, roof ? SurfaceKind::roof : SurfaceKind::wall, first_plane + cell.face_plane[f], face.ring);
    roofs += roof;
    for (Vec3 p : face.ring) {
      ridge = std::max(ridge, p.z);
      ground = std::min(ground, p.z);
    }
    if (!roof) floor.push_back(face.ring[0]);  // the walls are in order around the house, and each begins at the ground
  }
  std::reverse(floor.begin(), floor.end());
  add_surface(model, SurfaceKind::ground, 0, floor);
  model.attributes = {{"building_id", std::int64_t{first_building} + house},
                      {"roof_type", std::string(name_of(form.roof))},
                      {"roof_faces", roofs},
                      {"eave_m", form.eave},
                      {"ridge_m", ridge},
                      {"ground_m", ground}};
  return model;
}

}  // namespace ilot::scan
