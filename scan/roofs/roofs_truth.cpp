// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roofs_truth.h"

#include <fmt/format.h>

#include <algorithm>

#include "scan/roofs/roofs_scan.h"
#include "scan/scanners/scan_record.h"

namespace ilot::scan {
namespace {

Vec3 in_town(const RoofBuilding& building, std::uint32_t vertex) {
  return building.frame.to_town(building.solid.vertices[vertex]);
}

std::vector<Vec3> ring_in_town(const RoofBuilding& building, const std::vector<std::uint32_t>& ring) {
  std::vector<Vec3> places;
  for (std::uint32_t v : ring) places.push_back(in_town(building, v));
  return places;
}

TruePolygon polygon_of(const RoofBuilding& building, std::uint32_t id, const RoofFace& face) {
  TruePolygon polygon{id, ring_in_town(building, face.rings[0]), {}};
  for (std::size_t r = 1; r < face.rings.size(); ++r) polygon.holes.push_back(ring_in_town(building, face.rings[r]));
  return polygon;
}

TruePlane ground_plane(const RoofTown& town) {
  const auto corner = [&](double x, double y) { return Vec3{x, y, town.ground.height(x, y)}; };
  const Rect& a = town.area;
  TruePlane plane;
  plane.id = kTownGround;
  plane.surface_class = "ground";
  plane.plane = town.ground.plane();
  plane.polygons.push_back({0, {corner(a.x0, a.y0), corner(a.x1, a.y0), corner(a.x1, a.y1), corner(a.x0, a.y1)}, {}});
  return plane;
}

std::vector<std::uint32_t> roof_planes(const RoofBuilding& building) {
  std::vector<std::uint32_t> ids;
  for (std::size_t f = 0; f < building.solid.faces.size(); ++f)
    if (building.solid.faces[f].part == RoofPart::roof) ids.push_back(kFirstTownPlane + building.face_plane[f]);
  return ids;
}

const RoofFace& floor_of(const RoofBuilding& building) {
  return *std::find_if(building.solid.faces.begin(), building.solid.faces.end(),
                       [](const RoofFace& f) { return f.part == RoofPart::floor; });
}

SurfaceKind kind_of(RoofPart part) {
  return part == RoofPart::roof ? SurfaceKind::roof : part == RoofPart::wall ? SurfaceKind::wall : SurfaceKind::ground;
}

}  // namespace

std::vector<TruePlane> planes_of_town(const RoofTown& town, const std::vector<std::uint64_t>& points) {
  std::vector<TruePlane> planes(town.plane_count + kFirstTownPlane);
  planes[kTownGround] = ground_plane(town);
  for (std::uint32_t b = 0; b < town.buildings.size(); ++b) {
    const RoofBuilding& building = town.buildings[b];
    for (std::size_t f = 0; f < building.solid.faces.size(); ++f) {
      const RoofFace& face = building.solid.faces[f];
      if (face.part == RoofPart::floor) continue;
      TruePlane& plane = planes[kFirstTownPlane + building.face_plane[f]];
      if (plane.polygons.empty()) {
        plane.id = kFirstTownPlane + building.face_plane[f];
        plane.surface_class = face.part == RoofPart::roof ? "roof" : "wall";
        plane.plane.n = building.frame.direction_to_town(face.plane.n);
        plane.plane.d = -dot(plane.plane.n, in_town(building, face.rings[0][0]));
      }
      plane.area += face_area(building.solid, face);
      plane.polygons.push_back(polygon_of(building, b + 1, face));
    }
  }
  for (TruePlane& plane : planes) plane.points = points[plane.id];
  return planes;
}

TrueBuilding truth_of_building(const RoofBuilding& building, std::uint32_t id) {
  TrueBuilding truth{id,
                     name_of(building.kind),
                     ring_in_town(building, floor_of(building).rings[0]),
                     roof_planes(building),
                     building.eave,
                     building.ridge,
                     building.floor};
  std::reverse(truth.footprint.begin(), truth.footprint.end());
  return truth;
}

Building model_of(const RoofBuilding& building, std::uint32_t id) {
  Building model;
  model.id = fmt::format("building-{}", id);
  for (std::uint32_t v = 0; v < building.solid.vertices.size(); ++v)
    model.vertices.push_back(in_town(building, v) + kSceneOrigin);
  for (std::size_t f = 0; f < building.solid.faces.size(); ++f) {
    const RoofFace& face = building.solid.faces[f];
    const bool seen = face.part != RoofPart::floor;
    model.surfaces.push_back({kind_of(face.part), seen ? kFirstTownPlane + building.face_plane[f] : 0, face.rings});
  }
  model.attributes = {{"building_id", std::int64_t{id}},
                      {"roof_type", std::string(name_of(building.kind))},
                      {"roof_faces", static_cast<std::int64_t>(roof_planes(building).size())},
                      {"eave_m", building.eave},
                      {"ridge_m", building.ridge},
                      {"ground_m", building.floor}};
  return model;
}

}  // namespace ilot::scan
