// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_stage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "kernels/geometry/ring.h"
#include "scan/models/face_groups.h"
#include "scan/models/model_openings.h"
#include "scan/models/outward.h"
#include "scan/models/plan_hull.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr double kLeastPlane = 0.05;   // square metres; smaller pieces are no planes for anybody
constexpr double kPaneWidth = 0.075;   // metres; bars of windows are narrower, panes are wider
constexpr double kParallelPane = 0.9;  // cosine of the greatest angle of a pane to the main direction of its window
constexpr double kBeforeWall = 0.002;  // metres that flush panes are put before their wall, which may have no hole
constexpr double kGroundTile = 20;     // metres

// Twice the area over the perimeter: the width of a long strip, half the side of a square.
double width_of(const ScannedFace& face) {
  double perimeter = 0;
  for (const auto& ring : face.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) perimeter += norm(ring[(i + 1) % ring.size()] - ring[i]);
  return perimeter > 0 ? 2 * face.area / perimeter : 0;
}

// The frames of windows are wood: all faces that are too narrow for a pane or look aside. Each window has a pane.
void tell_panes_from_frames(std::vector<ScannedFace>& faces, const std::vector<std::uint32_t>& elements) {
  std::map<std::uint32_t, std::size_t> largest;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].face_class != FaceClass::window) continue;
    const auto [entry, added] = largest.try_emplace(elements[i], i);
    if (!added && faces[i].area > faces[entry->second].area) entry->second = i;
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    ScannedFace& face = faces[i];
    if (face.face_class != FaceClass::window || face.material != Material::glass) continue;
    const std::size_t main = largest.at(elements[i]);
    const bool parallel = std::abs(dot(face.normal, faces[main].normal)) >= kParallelPane;
    if (i != main && (!parallel || width_of(face) < kPaneWidth)) face.material = Material::wood;
  }
}

void move_by(ScannedFace& face, Vec3 by) {
  for (auto& ring : face.rings)
    for (Vec3& p : ring) p = p + by;
  for (Triangle3& t : face.triangles) t = {t.a + by, t.b + by, t.c + by};
}

Vec3 middle_of(const Triangle3& t) {
  return (1.0 / 3) * (t.a + t.b + t.c);
}

// Fits a plane to the corners of faces that lie on one: the mean of their normals, weighted by area.
Plane common_plane(const std::vector<const ScannedFace*>& faces, const Outward& outward) {
  Vec3 sum, centre;
  const ScannedFace* largest = faces[0];
  double area = 0;
  for (const ScannedFace* face : faces) {
    const double sign = dot(face->normal, faces[0]->normal) < 0 ? -1 : 1;
    sum = sum + (sign * face->area) * face->normal;
    for (const Triangle3& t : face->triangles) {
      const double part = norm(cross(t.b - t.a, t.c - t.a)) / 2;
      centre = centre + part * middle_of(t);
      area += part;
    }
    if (face->area > largest->area) largest = face;
  }
  const auto widest = std::max_element(largest->triangles.begin(), largest->triangles.end(), [](auto& s, auto& t) {
    return norm(cross(s.b - s.a, s.c - s.a)) < norm(cross(t.b - t.a, t.c - t.a));
  });
  const Vec3 n = outward.of(middle_of(*widest), (1 / norm(sum)) * sum);
  return {n, -dot(n, (1 / area) * centre)};
}

TruePolygon polygon_of(const ScannedFace& face, Vec3 out) {
  const bool turned = dot(face.normal, out) < 0;
  TruePolygon polygon{face.building, face.rings[0], {face.rings.begin() + 1, face.rings.end()}};
  if (turned) std::reverse(polygon.ring.begin(), polygon.ring.end());
  return polygon;
}

std::vector<Vec3> hull_of(const std::vector<const ScannedFace*>& faces, double z) {
  std::vector<FlatPoint> points;
  for (const ScannedFace* face : faces)
    for (const Vec3& p : face->rings[0]) points.push_back({p.x, p.y});
  std::vector<Vec3> hull;
  for (const FlatPoint& p : plan_hull(points, 1 / kUnit)) hull.push_back({p.x, p.y, z});
  return hull;
}

class StageBuilder {
 public:
  StageBuilder(const ScannedModel& model, ModelStage& stage) : model_(model), stage_(stage) {}

  void add_faces(const std::vector<std::uint32_t>& elements, const Outward& outward) {
    const std::vector<std::uint32_t> groups = plane_of_faces(model_, elements);
    const std::uint32_t count = groups.empty() ? 0 : 1 + *std::max_element(groups.begin(), groups.end());
    std::vector<std::vector<const ScannedFace*>> members(count);
    for (std::size_t i = 0; i < groups.size(); ++i) members[groups[i]].push_back(&model_.faces[i]);
    std::vector<std::uint32_t> ids(count);
    for (std::uint32_t g = 0; g < count; ++g) ids[g] = add_plane(members[g], outward);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const ScannedFace& face = model_.faces[i];
      if (ids[groups[i]] && elements[i]) stage_.planes[ids[groups[i]] - 1].element = elements[i];
      const SurfaceId surface =
          surface_of({static_cast<std::uint8_t>(face.face_class), ids[groups[i]], elements[i], face.material});
      for (const Triangle3& t : face.triangles)
        if (const auto part = facet(t.a, t.b, t.c, surface)) stage_.scene.parts.push_back(*part);
    }
  }

  void add_buildings() {
    std::vector<std::vector<const ScannedFace*>> of_building(model_.buildings.size());
    for (const ScannedFace& face : model_.faces)
      if (face.building) of_building[face.building - 1].push_back(&face);
    for (std::size_t b = 0; b < of_building.size(); ++b) {
      double low = INFINITY, ridge = -INFINITY, eave = INFINITY;
      for (const ScannedFace* face : of_building[b])
        for (const Vec3& p : face->rings[0]) {
          low = std::min(low, p.z);
          ridge = std::max(ridge, p.z);
          if (face->face_class == FaceClass::roof) eave = std::min(eave, p.z);
        }
      if (of_building[b].empty()) low = ridge = 0;
      TrueBuilding building{static_cast<std::uint32_t>(b + 1),
                            "",
                            hull_of(of_building[b], low),
                            {},
                            eave < INFINITY ? eave : ridge,
                            ridge,
                            low};
      for (const TruePlane& plane : stage_.planes)
        if (plane.surface_class == name_of(FaceClass::roof) && plane.polygons[0].building == b + 1)
          building.faces.push_back(plane.id);
      stage_.footprints.push_back(building.footprint);
      stage_.buildings.push_back(std::move(building));
    }
  }

  // Flat ground in tiles, so that rays meet few of its triangles.
  void add_ground(double margin) {
    const double z = stage_.ground_z;
    const double x0 = stage_.box.min.x - margin, x1 = stage_.box.max.x + margin;
    const double y0 = stage_.box.min.y - margin, y1 = stage_.box.max.y + margin;
    TruePlane plane;
    plane.id = static_cast<std::uint32_t>(stage_.planes.size() + 1);
    plane.surface_class = name_of(FaceClass::ground);
    plane.plane = {{0, 0, 1}, -z};
    plane.area = (x1 - x0) * (y1 - y0);
    plane.polygons.push_back({0, {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, {}});
    stage_.planes.push_back(plane);
    const SurfaceId surface =
        surface_of({static_cast<std::uint8_t>(FaceClass::ground), plane.id, 0, Material::asphalt});
    const auto tiles = [](double a, double b) { return static_cast<int>(std::ceil((b - a) / kGroundTile)); };
    const int nx = tiles(x0, x1), ny = tiles(y0, y1);
    const auto at = [](double a, double b, int i, int n) { return i == n ? b : a + (b - a) * i / n; };
    for (int i = 0; i < nx; ++i)
      for (int k = 0; k < ny; ++k) {
        const Vec3 a{at(x0, x1, i, nx), at(y0, y1, k, ny), z}, c{at(x0, x1, i + 1, nx), at(y0, y1, k + 1, ny), z};
        const Vec3 b{c.x, a.y, z}, d{a.x, c.y, z};
        stage_.scene.parts.push_back(*facet(a, b, c, surface));
        stage_.scene.parts.push_back(*facet(a, c, d, surface));
      }
  }

 private:
  std::uint32_t add_plane(const std::vector<const ScannedFace*>& faces, const Outward& outward) {
    double area = 0;
    for (const ScannedFace* face : faces) area += face->area;
    if (area < kLeastPlane) return 0;
    TruePlane plane;
    plane.id = static_cast<std::uint32_t>(stage_.planes.size() + 1);
    plane.surface_class = name_of(faces[0]->face_class);
    plane.plane = common_plane(faces, outward);
    plane.area = area;
    for (const ScannedFace* face : faces) plane.polygons.push_back(polygon_of(*face, plane.plane.n));
    stage_.planes.push_back(std::move(plane));
    return stage_.planes.back().id;
  }

  SurfaceId surface_of(const SurfaceLabel& label) {
    const auto key = std::tuple(label.true_class, label.plane, label.element, label.material);
    const auto found = surfaces_.find(key);
    if (found != surfaces_.end()) return found->second;
    return surfaces_[key] = stage_.scene.add_surface(label);
  }

  const ScannedModel& model_;
  ModelStage& stage_;
  std::map<std::tuple<std::uint8_t, std::uint32_t, std::uint32_t, Material>, SurfaceId> surfaces_;
};

std::vector<Part> bare_parts(const ScannedModel& model) {
  std::vector<Part> parts;
  for (const ScannedFace& face : model.faces)
    for (const Triangle3& t : face.triangles)
      if (const auto part = facet(t.a, t.b, t.c, 0)) parts.push_back(*part);
  return parts;
}

bool has_terrain(const ScannedModel& model) {
  return std::any_of(model.faces.begin(), model.faces.end(),
                     [](const ScannedFace& face) { return face.face_class == FaceClass::ground; });
}

}  // namespace

ModelStage make_stage(ScannedModel&& model, double ground) {
  ModelStage stage;
  stage.place = model.place;
  stage.box = model.box;
  stage.ground_z = model.box.min.z;
  const std::vector<std::uint32_t> elements = element_of_faces(model);
  tell_panes_from_frames(model.faces, elements);
  const std::vector<Part> bare = bare_parts(model);
  const Outward outward(bare);
  ElementOutlines outlines = element_outlines(model, elements, outward);
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements[i] && outlines.flush[elements[i] - 1] && model.faces[i].face_class != FaceClass::installation)
      move_by(model.faces[i], kBeforeWall * outlines.outward[elements[i] - 1]);
  StageBuilder builder(model, stage);
  builder.add_faces(elements, outward);
  builder.add_buildings();
  if (ground > 0 && !has_terrain(model)) builder.add_ground(ground);
  stage.elements = std::move(outlines.elements);
  stage.openings = std::move(outlines.openings);
  stage.opening_normals = std::move(outlines.normals);
  return stage;
}

}  // namespace ilot::scan
