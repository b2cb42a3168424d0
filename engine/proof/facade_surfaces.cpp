// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/facade_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/deliverables/solids/facade_solids.h"

namespace ilot {
namespace {

constexpr double kFrontLeast = 0.7;  // least component of a front's normal out of the wall

Vec3 local(const Facade& f, Vec3 place, double metres) {
  const Vec3 d = metres * (place - f.origin);
  return {dot(d, f.right), dot(d, f.up), dot(d, f.out)};
}

Vec3 unit_normal(const std::vector<Vec3>& corners) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  const double length = norm(sum);
  return length > 0 ? (1 / length) * sum : Vec3{0, 0, 1};
}

FaceName name_of(Vec3 outwards) {
  if (std::abs(outwards.z) >= kFrontLeast) return FaceName::front;
  if (std::abs(outwards.x) > std::abs(outwards.y)) return outwards.x > 0 ? FaceName::right : FaceName::left;
  return outwards.y > 0 ? FaceName::top : FaceName::bottom;
}

double mean_out(const std::vector<Vec3>& corners) {
  double sum = 0;
  for (const Vec3& p : corners) sum += p.z;
  return sum / static_cast<double>(corners.size());
}

// Adds the faces of a closed solid except those at the wall. Of two faces that look along the wall's normal, the
// farther one is the front.
void add_solid(const FacadeSolid& solid, const Facade& facade, std::uint32_t element, bool hollow, double metres,
               std::vector<SurfaceFace>& faces) {
  const std::size_t before = faces.size();
  double farthest = 0;
  for (const auto& corners : solid.faces) {
    SurfaceFace face{element, FaceName::front, {}, {}};
    for (const std::uint32_t i : corners) face.corners.push_back(local(facade, solid.vertices[i], metres));
    const Vec3 outwards = unit_normal(face.corners);
    face.name = name_of(outwards);
    face.visible = (hollow ? -1.0 : 1.0) * outwards;
    if (face.name == FaceName::front) farthest = std::max(farthest, std::abs(mean_out(face.corners)));
    faces.push_back(std::move(face));
  }
  faces.erase(std::remove_if(faces.begin() + static_cast<std::ptrdiff_t>(before), faces.end(),
                             [&](const SurfaceFace& f) {
                               return f.name == FaceName::front && std::abs(mean_out(f.corners)) < farthest;
                             }),
              faces.end());
}

std::map<std::uint32_t, const FacadeSolid*> by_element(const std::vector<FacadeSolid>& solids) {
  std::map<std::uint32_t, const FacadeSolid*> by;
  for (const FacadeSolid& s : solids) by[s.element] = &s;
  return by;
}

}  // namespace

std::vector<Vec3> local_ring(const Facade& facade, const FacadeElement& element, double metres_per_unit) {
  std::vector<Vec3> ring;
  for (const Vec3& p : element.ring) ring.push_back(local(facade, p, metres_per_unit));
  return ring;
}

std::vector<SurfaceFace> facade_surfaces(const Facade& facade, double metres_per_unit) {
  const std::vector<FacadeSolid> solids = facade_solids(facade, metres_per_unit), meshes = facade_meshes(facade);
  const auto solid_of = by_element(solids), mesh_of = by_element(meshes);
  std::vector<SurfaceFace> faces;
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) {
    const FacadeElement& e = facade.elements[i];
    if (e.status == DrawnStatus::occluded || e.region == FacadeRegion::facade) continue;
    if (const auto solid = solid_of.find(e.id); solid != solid_of.end()) {
      add_solid(*solid->second, facade, i, e.depth_m < 0, metres_per_unit, faces);
    } else if (const auto mesh = mesh_of.find(e.id); mesh != mesh_of.end()) {
      for (const auto& t : mesh->second->faces) {
        SurfaceFace face{i, FaceName::front, {}, {}};
        for (const std::uint32_t c : t)
          face.corners.push_back(local(facade, mesh->second->vertices[c], metres_per_unit));
        face.visible = unit_normal(face.corners);
        faces.push_back(std::move(face));
      }
    } else if (!e.opening && e.ring.size() >= 3) {
      faces.push_back({i, FaceName::front, local_ring(facade, e, metres_per_unit), {0, 0, 1}});
    }
  }
  return faces;
}

WallSurface wall_surface(const Facade& facade, double metres_per_unit) {
  WallSurface wall;
  std::vector<FlatEdge> edges;
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) {
    const FacadeElement& e = facade.elements[i];
    const bool outline = e.region == FacadeRegion::facade;
    if (!outline && (e.status == DrawnStatus::occluded || !e.opening || !is_hole(facade, e, metres_per_unit))) continue;
    if (outline && wall.element == WallSurface::kNone) wall.element = i;
    std::vector<FlatPoint> ring = chords_of(flat_element(facade, e, metres_per_unit));
    for (FlatPoint& p : ring) p.y -= metres_per_unit * facade.origin.z;
    if (ring.size() < 3) continue;
    add_ring(ring, edges);
    wall.rings.push_back(std::move(ring));
  }
  if (wall.element == WallSurface::kNone) return {};
  wall.region = BandedRegion(edges);
  return wall;
}

}  // namespace ilot
