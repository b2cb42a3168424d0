// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_openings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/compare/planes/plane_frame.h"
#include "engine/flat_area.h"
#include "kernels/geometry/ring.h"
#include "scan/models/plan_hull.h"

namespace ilot::scan {
namespace {

constexpr double kParallel = 0.9659;    // cosine of 15 degrees
constexpr double kReach = 1.0;          // metres from an opening to its wall
constexpr double kMargin = 0.5;         // metres that the middle may lie outside the box of its wall
constexpr double kFlush = 0.02;         // metres
constexpr double kOneFacade = 0.2;      // metres; walls nearer than that are one facade, as evaluate has it
constexpr double kSameFacade = 0.9962;  // cosine of 5 degrees
constexpr double kWhole = 0.8;          // share of the union that one piece must have
constexpr double kStraight = 0.001;     // metres: vertices nearer to the line between their neighbours are dropped
constexpr double kGrid = 0.0005;        // metres: faces with gaps below that are one in the union
constexpr double kHullSteps = 10000;    // per metre

struct Wall {
  Vec3 normal, point;
  std::uint32_t building = 0;
};

using Members = std::vector<const ScannedFace*>;

bool can_be_wall(const ScannedFace& face) {
  return face.face_class == FaceClass::facade || face.face_class == FaceClass::roof;
}

Vec3 middle_of(const Members& faces) {
  Box3<Vec3> box = Box3<Vec3>::none();
  for (const ScannedFace* face : faces)
    for (const Vec3& p : face->rings[0]) box.add(p);
  return 0.5 * (box.min + box.max);
}

const ScannedFace& largest(const Members& faces) {
  return **std::max_element(faces.begin(), faces.end(),
                            [](const ScannedFace* a, const ScannedFace* b) { return a->area < b->area; });
}

Wall wall_of(const ScannedModel& model, const Members& faces) {
  const ScannedFace& main = largest(faces);
  const Vec3 middle = middle_of(faces);
  const std::optional<std::uint32_t> parent = model.surfaces[main.surface].parent;
  const ScannedFace* best = nullptr;
  double nearest = 2 * kReach;
  for (const ScannedFace& face : model.faces) {
    if (face.building != main.building || !can_be_wall(face)) continue;
    if (std::abs(dot(face.normal, main.normal)) < kParallel) continue;
    const double distance = std::abs(dot(face.normal, middle - face.rings[0][0]));
    // A wall of the parent surface comes before all others.
    const double rank = distance + (parent && face.surface == *parent ? 0 : kReach);
    if (distance > kReach || !(rank < nearest)) continue;
    Box3<Vec3> box = Box3<Vec3>::none();
    for (const Vec3& p : face.rings[0]) box.add(p);
    if (!box.grown(kMargin).contains(middle)) continue;
    best = &face;
    nearest = rank;
  }
  if (!best) return {main.normal, main.rings[0][0], main.building};
  return {best->normal, best->rings[0][0], main.building};
}

std::vector<FlatPoint> without_straight(std::vector<FlatPoint> ring) {
  for (std::size_t i = 0; ring.size() > 3 && i < ring.size();) {
    const FlatPoint a = ring[(i + ring.size() - 1) % ring.size()], b = ring[(i + 1) % ring.size()];
    const double twice = std::abs(orient2d(a, ring[i], b)), length = distance(a, b);
    if (length > 0 ? twice <= kStraight * length : true)
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return ring;
}

std::vector<FlatPoint> hull_of(const std::vector<FlatPolygon>& polygons) {
  std::vector<FlatPoint> points;
  for (const FlatPolygon& polygon : polygons) points.insert(points.end(), polygon.ring.begin(), polygon.ring.end());
  return plan_hull(points, kHullSteps);
}

std::vector<FlatPoint> outline_of(const Members& faces, const FlatFrame& frame) {
  std::vector<FlatPolygon> polygons;
  for (const ScannedFace* face : faces)
    for (const Triangle3& t : face->triangles) {
      FlatPolygon polygon{{frame.flat(t.a), frame.flat(t.b), frame.flat(t.c)}, {}};
      if (std::abs(doubled_area(polygon.ring)) > 1e-6) polygons.push_back(std::move(polygon));
    }
  if (polygons.empty()) return {};
  const FlatArea area(polygons, kGrid);
  std::vector<FlatPoint> ring = area.largest_ring();
  if (std::abs(doubled_area(ring)) / 2 < kWhole * area.area()) ring = hull_of(polygons);
  ring = without_straight(std::move(ring));
  if (doubled_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  return ring.size() >= 3 ? ring : std::vector<FlatPoint>{};
}

// The frame of a wall seen from outside: u to the right, v upwards.
FlatFrame upright_frame(Vec3 out, Vec3 origin) {
  const Vec3 right = cross({0, 0, 1}, out);
  if (!(norm(right) > 0.1)) return plane_frame(out, origin);
  const Vec3 u = (1 / norm(right)) * right;
  return {origin, u, cross(out, u)};
}

void measure_depth(const Members& faces, const Wall& wall, TrueElement& e, bool& flush) {
  double moment = 0, weight = 0;
  flush = true;
  for (const ScannedFace* face : faces) {
    const bool parallel = std::abs(dot(face->normal, wall.normal)) >= kParallel;
    double sum = 0;
    for (const Vec3& p : face->rings[0]) {
      const double d = dot(wall.normal, p - wall.point);
      sum += d;
      flush = flush && std::abs(d) <= kFlush;
    }
    if (!parallel) continue;
    moment += face->area * sum / static_cast<double>(face->rings[0].size());
    weight += face->area;
  }
  e.depth = weight > 0 ? moment / weight : 0;
}

const char* kind_of(FaceClass c) {
  return c == FaceClass::window ? "window" : c == FaceClass::door ? "door" : "installation";
}

std::uint32_t facade_of(const Wall& wall, std::vector<Wall>& facades) {
  const auto found = std::find_if(facades.begin(), facades.end(), [&](const Wall& f) {
    return f.building == wall.building && dot(f.normal, wall.normal) >= kSameFacade &&
           std::abs(dot(f.normal, wall.point - f.point)) <= kOneFacade;
  });
  if (found != facades.end()) return static_cast<std::uint32_t>(found - facades.begin() + 1);
  facades.push_back(wall);
  return static_cast<std::uint32_t>(facades.size());
}

}  // namespace

ElementOutlines element_outlines(const ScannedModel& model, std::span<const std::uint32_t> elements,
                                 const Outward& outward) {
  const std::uint32_t count = elements.empty() ? 0 : *std::max_element(elements.begin(), elements.end());
  std::vector<Members> members(count);
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements[i]) members[elements[i] - 1].push_back(&model.faces[i]);
  ElementOutlines out;
  std::vector<Wall> facades;
  for (std::uint32_t n = 0; n < count; ++n) {
    const Members& faces = members[n];
    Wall wall = wall_of(model, faces);
    const Vec3 middle = middle_of(faces);
    const Vec3 on_wall = middle - dot(wall.normal, middle - wall.point) * wall.normal;
    wall.normal = outward.of(on_wall, wall.normal);
    TrueElement e;
    e.id = n + 1;
    e.kind = kind_of(faces[0]->face_class);
    bool flush = false;
    measure_depth(faces, wall, e, flush);
    const FlatFrame frame = upright_frame(wall.normal, on_wall);
    const std::vector<FlatPoint> ring = outline_of(faces, frame);
    double area = 0;
    if (!ring.empty()) {
      const auto [left, right] =
          std::minmax_element(ring.begin(), ring.end(), [](auto a, auto b) { return a.x < b.x; });
      const auto [low, high] = std::minmax_element(ring.begin(), ring.end(), [](auto a, auto b) { return a.y < b.y; });
      e.width = right->x - left->x;
      e.height = high->y - low->y;
      for (const FlatPoint p : ring) e.ring.push_back(frame.origin + p.x * frame.u + p.y * frame.v);
      area = doubled_area(ring) / 2;
    }
    e.seen = TrueSight{0, area, flush};
    out.flush.push_back(flush);
    out.outward.push_back(wall.normal);
    if (faces[0]->face_class != FaceClass::installation && !e.ring.empty()) {
      e.facade = facade_of(wall, facades);
      out.openings.push_back({static_cast<std::uint32_t>(out.openings.size() + 1), e.id, e.facade, e.ring, e.seen});
      out.normals.push_back(wall.normal);
    }
    out.elements.push_back(std::move(e));
  }
  return out;
}

}  // namespace ilot::scan
