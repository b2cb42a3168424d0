// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/roof_surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

constexpr double kUprightFace = 0.01;  // a face whose unit normal has a smaller z has no usable plan

// A face as a model of its own, so that true rings and faces of models are processed in the same way.
struct FaceShape {
  std::uint32_t building = 0;
  PolygonModel model;
};

void add_polygon(FaceShape& shape, const std::vector<const Ring3*>& rings) {
  PolygonFace face;
  for (const Ring3* ring : rings) {
    face.rings.emplace_back();
    for (const Vec3& p : *ring) {
      face.rings.back().push_back(static_cast<std::uint32_t>(shape.model.vertices.size()));
      shape.model.vertices.push_back(p);
    }
  }
  shape.model.faces.push_back(std::move(face));
}

std::vector<FlatPoint> plan_of(const PolygonModel& model, const std::vector<std::uint32_t>& ring, Vec3 origin) {
  std::vector<FlatPoint> plan;
  for (const std::uint32_t i : ring) plan.push_back({model.vertices[i].x - origin.x, model.vertices[i].y - origin.y});
  return plan;
}

void set_box(RoofFace& face) {
  face.box = FlatBox::none();
  for (const FlatPolygon& polygon : face.plan)
    for (const FlatPoint p : polygon.ring) face.box.add(p);
}

// Appends the shape as one face, unless it stands upright or has no area.
void append_face(const FaceShape& shape, Vec3 origin, std::vector<RoofFace>& faces) {
  RoofFace face;
  face.building = shape.building;
  for (const PolygonFace& polygon : shape.model.faces) {
    Vec3 n = 0.5 * face_normal(shape.model, polygon);
    face.normal = face.normal + (n.z < 0 ? -1.0 : 1.0) * n;
    append_triangles(shape.model, polygon, face.triangles);
    face.plan.push_back({plan_of(shape.model, polygon.rings[0], origin), {}});
    for (std::size_t hole = 1; hole < polygon.rings.size(); ++hole) {
      n = 0.5 * face_normal(shape.model, {{polygon.rings[hole]}, FaceKind::unknown, 0});
      face.normal = face.normal - (n.z < 0 ? -1.0 : 1.0) * n;
      face.plan.back().holes.push_back(plan_of(shape.model, polygon.rings[hole], origin));
    }
  }
  if (!(face.normal.z > kUprightFace * norm(face.normal))) return;
  for (Triangle3& t : face.triangles) t = {t.a - origin, t.b - origin, t.c - origin};
  Vec3 centre;
  const std::vector<std::uint32_t>& ring = shape.model.faces[0].rings[0];
  for (const std::uint32_t i : ring)
    centre = centre + (1.0 / static_cast<double>(ring.size())) * (shape.model.vertices[i] - origin);
  face.offset = -dot(face.normal, centre);
  set_box(face);
  faces.push_back(std::move(face));
}

}  // namespace

double RoofFace::area() const {
  return norm(normal);
}

double RoofFace::height(FlatPoint p) const {
  return -(normal.x * p.x + normal.y * p.y + offset) / normal.z;
}

std::vector<RoofFace> true_roofs(std::span<const TruePlane> planes, Vec3 origin) {
  std::vector<RoofFace> faces;
  for (const TruePlane& plane : planes) {
    if (plane.class_name != "roof") continue;
    std::map<std::uint32_t, FaceShape> per_building;
    for (const TruePolygon& polygon : plane.polygons) {
      std::vector<const Ring3*> rings{&polygon.ring};
      for (const Ring3& hole : polygon.holes) rings.push_back(&hole);
      FaceShape& shape = per_building[polygon.building];
      shape.building = polygon.building;
      add_polygon(shape, rings);
    }
    for (const auto& [building, shape] : per_building) append_face(shape, origin, faces);
  }
  return faces;
}

std::vector<RoofFace> model_roofs(std::span<const PolygonModel> models, Vec3 origin, double metres_per_unit) {
  std::vector<RoofFace> faces;
  for (std::uint32_t m = 0; m < models.size(); ++m) {
    const std::vector<bool> roofs = roof_faces(models[m], metres_per_unit);
    for (std::size_t f = 0; f < roofs.size(); ++f)
      if (roofs[f]) append_face({m, {"", models[m].vertices, {models[m].faces[f]}}}, origin, faces);
  }
  return faces;
}

bool covers(const RoofFace& face, FlatPoint p) {
  bool inside = false;
  const auto flip = [&](const std::vector<FlatPoint>& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      inside ^= ray_crosses_by_share(p, ring[i], ring[j]);
  };
  for (const FlatPolygon& polygon : face.plan) {
    flip(polygon.ring);
    for (const std::vector<FlatPoint>& hole : polygon.holes) flip(hole);
  }
  return inside;
}

std::vector<FlatEdge> plan_edges(const RoofFace& face) {
  std::vector<FlatEdge> edges;
  for (const FlatPolygon& polygon : face.plan) {
    add_ring(polygon.ring, edges);
    for (const std::vector<FlatPoint>& hole : polygon.holes) add_ring(hole, edges);
  }
  return edges;
}

}  // namespace ilot
