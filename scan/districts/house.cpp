// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/house.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ilot::scan {
namespace {

// The corners of a house in a frame whose first axis is parallel to the ridge, counter-clockwise from the lower left.
struct Frame {
  const HouseForm& form;
  SinCos heading;
  double half_length, half_span;

  Vec3 place(double along, double across, double z) const {
    return {form.x + along * heading.cos - across * heading.sin, form.y + along * heading.sin + across * heading.cos,
            z};
  }
};

bool ridge_follows_street(const HouseForm& form) {
  if (form.roof == RoofShape::hip) return form.width >= form.depth;
  return form.ridge == Ridge::along_street;
}

Frame ridge_frame(const HouseForm& form) {
  if (ridge_follows_street(form)) return {form, form.heading, form.width / 2, form.depth / 2};
  return {form, {form.heading.cos, -form.heading.sin}, form.depth / 2, form.width / 2};
}

// Computes Newell's normal relative to the first vertex, which is exact enough far from the origin.
Plane plane_of(const std::vector<Vec3>& ring) {
  Vec3 normal{0, 0, 0};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) normal = normal + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  const Vec3 unit = (1 / norm(normal)) * normal;
  return {unit, -dot(unit, ring[0])};
}

void add_face(std::vector<Face>& faces, Surface surface, std::vector<Vec3> ring) {
  const auto same = [](Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
  const Plane plane = plane_of(ring);
  faces.push_back({surface, plane, std::move(ring)});
}

}  // namespace

Plane Ground::plane() const {
  const double length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
  return {{-slope_x / length, -slope_y / length, 1 / length}, -base / length};
}

double roof_span(const HouseForm& form) {
  return 2 * ridge_frame(form).half_span;
}

std::vector<Face> house_faces(const HouseForm& form, const Ground& ground) {
  const Frame frame = ridge_frame(form);
  const double length = frame.half_length, span = frame.half_span;
  const double rise = form.roof == RoofShape::flat ? 0 : span * tan_deg(form.pitch_deg);
  const double ridge = form.roof == RoofShape::hip ? length - span : length;
  const std::array<std::array<double, 2>, 4> corners{
      {{-length, -span}, {length, -span}, {length, span}, {-length, span}}};
  std::array<Vec3, 4> eave, foot;
  for (std::size_t i = 0; i < 4; ++i) {
    eave[i] = frame.place(corners[i][0], corners[i][1], form.eave);
    foot[i] = {eave[i].x, eave[i].y, ground.height(eave[i].x, eave[i].y)};
  }
  const Vec3 right = frame.place(ridge, 0, form.eave + rise);
  const Vec3 left = ridge == 0 ? right : frame.place(-ridge, 0, form.eave + rise);

  std::vector<Face> faces;
  if (form.roof == RoofShape::flat) {
    add_face(faces, Surface::roof, {eave.begin(), eave.end()});
  } else {
    add_face(faces, Surface::roof, {eave[0], eave[1], right, left});
    add_face(faces, Surface::roof, {eave[2], eave[3], left, right});
  }
  if (form.roof == RoofShape::hip) {
    add_face(faces, Surface::roof, {eave[1], eave[2], right});
    add_face(faces, Surface::roof, {eave[3], eave[0], left});
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    std::vector<Vec3> ring{foot[i], foot[next], eave[next], eave[i]};
    if (form.roof == RoofShape::gable && i % 2 == 1) ring.insert(ring.begin() + 3, i == 1 ? right : left);
    add_face(faces, Surface::wall, std::move(ring));
  }
  return faces;
}

ConvexSolid house_solid(const std::vector<Face>& faces, std::uint32_t first_face) {
  ConvexSolid solid;
  solid.first_face = first_face;
  solid.bounds = {faces[0].ring[0], faces[0].ring[0]};
  for (const Face& face : faces) {
    solid.planes[solid.face_count++] = face.plane;
    for (Vec3 p : face.ring) solid.bounds.add(p);
  }
  return solid;
}

double distance_to_footprint(const HouseForm& form, double x, double y) {
  const double dx = x - form.x, dy = y - form.y;
  const double along = std::abs(dx * form.heading.cos + dy * form.heading.sin) - form.width / 2;
  const double across = std::abs(dy * form.heading.cos - dx * form.heading.sin) - form.depth / 2;
  const double a = std::max(along, 0.0), b = std::max(across, 0.0);
  return std::sqrt(a * a + b * b);
}

}  // namespace ilot::scan
