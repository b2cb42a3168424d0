// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/part.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "kernels/geometry/ring.h"
#include "scan/optics/arch.h"

namespace ilot::scan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 facing(Vec3 normal, const Ray& ray) {
  return dot(normal, ray.direction) > 0 ? -1.0 * normal : normal;
}

// Returns the interval where a t^2 + 2 b t + c <= 0, for a > 0.
std::optional<Chord> between_roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Chord{(-b - root) / a, (-b + root) / a};
}

std::optional<Chord> cone_chord(const Ray& ray, const Quadric& cone) {
  const Vec3 from_apex = ray.origin - cone.point;
  const double height = dot(from_apex, cone.axis), climb = dot(ray.direction, cone.axis);
  const double stretch = 1 + cone.tangent * cone.tangent;
  const double a = 1 - stretch * climb * climb;
  const double b = dot(from_apex, ray.direction) - stretch * height * climb;
  const double c = dot(from_apex, from_apex) - stretch * height * height;
  if (a > 0) {
    const auto both = between_roots(a, b, c);
    if (!both || height + climb * (both->enter + both->leave) / 2 < 0) return std::nullopt;
    return both;
  }
  if (a == 0) return std::nullopt;  // the ray is parallel to the mantle; this is negligibly rare
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  const double first = (-b + root) / a, last = (-b - root) / a;  // a < 0: first <= last
  return climb > 0 ? Chord{last, kInfinity} : Chord{-kInfinity, first};
}

Box3<Vec3> bounds_of_points(std::span<const Vec3> points) {
  Box3<Vec3> box{points[0], points[0]};
  for (Vec3 p : points) box.add(p);
  return box;
}

// Returns half the extent of a disc along each axis.
Vec3 disc_extent(Vec3 axis, double radius) {
  const auto extent = [&](double a) { return radius * std::sqrt(std::max(0.0, 1 - a * a)); };
  return {extent(axis.x), extent(axis.y), extent(axis.z)};
}

// Finds the entry into a convex solid, as enter() of solid.h does, with a quadric as one more constraint.
std::optional<PartHit> meet_solid(const Ray& ray, const Solid& solid, double from) {
  double leave = kInfinity, enter = -kInfinity;
  std::uint32_t face = 0;
  for (std::uint32_t i = 0; i < solid.plane_count; ++i) {
    const Plane& plane = solid.planes[i];
    const double rate = dot(plane.n, ray.direction), distance = signed_distance(plane, ray.origin);
    if (rate == 0) {
      if (distance > 0) return std::nullopt;
      continue;
    }
    const double t = -distance / rate;
    if (rate < 0 && t > enter) {
      enter = t;
      face = i;
    }
    if (rate > 0 && t < leave) leave = t;
    if (enter > leave) return std::nullopt;
  }
  if (solid.quadric.kind != Quadric::Kind::none) {
    const auto inside = chord(ray, solid.quadric);
    if (!inside) return std::nullopt;
    if (inside->enter > enter) {
      enter = inside->enter;
      face = solid.plane_count;
    }
    if (enter > std::min(leave, inside->leave)) return std::nullopt;
  }
  if (!(enter > from)) return std::nullopt;
  const Vec3 normal = face < solid.plane_count ? solid.planes[face].n : normal_at(solid.quadric, point_at(ray, enter));
  return PartHit{enter, solid.surfaces[face], facing(normal, ray)};
}

std::optional<PartHit> meet_panel(const Ray& ray, const Panel& panel, double from) {
  const Vec3 normal = cross(panel.u, panel.v);
  const double rate = dot(normal, ray.direction);
  if (rate == 0) return std::nullopt;
  const double t = dot(normal, panel.origin - ray.origin) / rate;
  if (!(t > from)) return std::nullopt;
  const Vec3 offset = point_at(ray, t) - panel.origin;
  const FlatPoint p{dot(panel.u, offset), dot(panel.v, offset)};
  if (!contains_by_share(panel.ring, p)) return std::nullopt;
  for (const Opening& opening : panel.openings)
    if (contains(opening, p)) return std::nullopt;
  return PartHit{t, panel.surface, facing(normal, ray)};
}

std::optional<PartHit> meet_shell(const Ray& ray, const Shell& shell, double from) {
  const auto inside = chord(ray, shell.quadric);
  if (!inside) return std::nullopt;
  for (double t : {inside->enter, inside->leave}) {
    if (!(t > from) || !(t < kInfinity)) continue;
    const Vec3 p = point_at(ray, t);
    if (std::any_of(shell.clips.begin(), shell.clips.end(), [&](const Plane& c) { return signed_distance(c, p) > 0; }))
      continue;
    return PartHit{t, shell.surface, facing(normal_at(shell.quadric, p), ray)};
  }
  return std::nullopt;
}

struct SheetPlace {
  double t = 0;
  FlatPoint p;  // in the panel
};

// Finds where the ray is `depth` behind the surface of the sheet. The surface deviates little from the panel's plane,
// so a constant, small number of steps of fixed-point iteration suffices. The large form comes first.
SheetPlace sheet_place(const Ray& ray, const Sheet& sheet, double rate, double reach, double depth) {
  constexpr int kFormSteps = 2, kReliefSteps = 2;
  const Panel& panel = sheet.panel;
  SheetPlace at{(reach - depth) / rate, {}};
  const auto land = [&] {
    const Vec3 offset = point_at(ray, at.t) - panel.origin;
    at.p = {dot(panel.u, offset), dot(panel.v, offset)};
  };
  land();
  const int steps = sheet.form.flat() ? kReliefSteps : kFormSteps + kReliefSteps;
  const bool rough = sheet.relief.roughness > 0 || sheet.relief.stone_out > 0;
  for (int step = 0; step < steps; ++step) {
    const double x = sheet.x + at.p.x, z = sheet.z + at.p.y;
    const double relief = rough && step + kReliefSteps >= steps ? relief_at(sheet.relief, x, z) : 0;
    at.t = (reach + sheet.form.at(x, z) + relief - depth) / rate;
    land();
  }
  return at;
}

// A ray into a joint meets its ground or, where it leaves the joint before, its side.
SheetPlace in_the_joint(const Ray& ray, const Sheet& sheet, double rate, double reach) {
  const auto is_joint = [&](const SheetPlace& at) {
    return in_joint(sheet.relief, sheet.x + at.p.x, sheet.z + at.p.y);
  };
  const SheetPlace ground = sheet_place(ray, sheet, rate, reach, sheet.relief.joint_depth);
  if (is_joint(ground)) return ground;
  double open = 0, closed = sheet.relief.joint_depth;
  for (int i = 0; i < 6; ++i) {
    const double middle = (open + closed) / 2;
    (is_joint(sheet_place(ray, sheet, rate, reach, middle)) ? open : closed) = middle;
  }
  return sheet_place(ray, sheet, rate, reach, open);
}

// Returns false where the ray meets the panel's plane so far outside the ring that the form cannot bring it back.
bool may_meet(const Ray& ray, const Sheet& sheet, double rate, double reach) {
  const Vec3 offset = point_at(ray, reach / rate) - sheet.panel.origin;
  const FlatPoint p{dot(sheet.panel.u, offset), dot(sheet.panel.v, offset)};
  const double slack = (sheet.form.most() + sheet.relief.most()) / std::abs(rate) + kOverlap;
  FlatPoint low = sheet.panel.ring[0], high = low;
  for (FlatPoint q : sheet.panel.ring) {
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
  return p.x > low.x - slack && p.x < high.x + slack && p.y > low.y - slack && p.y < high.y + slack;
}

std::optional<PartHit> meet_sheet(const Ray& ray, const Sheet& sheet, double from) {
  const Panel& panel = sheet.panel;
  const Vec3 normal = cross(panel.u, panel.v);
  const double rate = dot(normal, ray.direction);
  if (rate == 0) return std::nullopt;
  const double reach = dot(normal, panel.origin - ray.origin);
  if (!may_meet(ray, sheet, rate, reach)) return std::nullopt;
  SheetPlace at = sheet_place(ray, sheet, rate, reach, 0);
  SurfaceId surface = panel.surface;
  if (in_joint(sheet.relief, sheet.x + at.p.x, sheet.z + at.p.y)) {
    at = in_the_joint(ray, sheet, rate, reach);
    surface = sheet.joint_surface;
  }
  if (!(at.t > from) || !contains_by_share(panel.ring, at.p)) return std::nullopt;
  for (const Opening& opening : panel.openings)
    if (contains(opening, at.p)) return std::nullopt;
  return PartHit{at.t, surface, facing(normal, ray)};
}

Box3<Vec3> bounds_of_panel(const Panel& panel, double thick) {
  std::vector<Vec3> corners;
  const Vec3 normal = cross(panel.u, panel.v);
  for (FlatPoint p : panel.ring)
    for (double side : {-thick, thick}) corners.push_back(panel.origin + p.x * panel.u + p.y * panel.v + side * normal);
  return bounds_of_points(corners);
}

// Returns where a place is relative to the ray, seen along the axis in which the ray is longest. All facets compute the
// same two numbers for a common corner.
FlatPoint beside(const Ray& ray, Vec3 place) {
  const Vec3 p = place - ray.origin, d = ray.direction;
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  if (z >= x && z >= y) return {p.x - d.x / d.z * p.z, p.y - d.y / d.z * p.z};
  if (x >= y) return {p.y - d.y / d.x * p.x, p.z - d.z / d.x * p.x};
  return {p.z - d.z / d.y * p.y, p.x - d.x / d.y * p.y};
}

// Watertight (Woop, Benthin, Wald 2013): the side of an edge is the sign of a difference of two rounded products, which
// is right or zero, and zero counts as inside. So no ray passes between facets with common corners.
std::optional<PartHit> meet_facet(const Ray& ray, const Facet& facet, double from) {
  const FlatPoint a = beside(ray, facet.a), b = beside(ray, facet.b), c = beside(ray, facet.c);
  const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  const bool left = ab >= 0 && bc >= 0 && ca >= 0, right = ab <= 0 && bc <= 0 && ca <= 0;
  const double rate = dot(facet.normal, ray.direction);
  if (!(left || right) || rate == 0) return std::nullopt;
  const double t = dot(facet.normal, facet.a - ray.origin) / rate;
  if (!(t > from)) return std::nullopt;
  return PartHit{t, facet.surface, facing(facet.normal, ray)};
}

void add_plane(Solid& solid, Vec3 normal, Vec3 through) {
  assert(solid.plane_count < Solid::kMaxPlanes);
  const Vec3 unit = (1 / norm(normal)) * normal;
  solid.planes[solid.plane_count++] = {unit, -dot(unit, through)};
}

}  // namespace

std::optional<Chord> chord(const Ray& ray, const Quadric& quadric) {
  const Vec3 offset = ray.origin - quadric.point;
  const double r2 = quadric.radius * quadric.radius;
  if (quadric.kind == Quadric::Kind::sphere)
    return between_roots(1, dot(offset, ray.direction), dot(offset, offset) - r2);
  if (quadric.kind == Quadric::Kind::cone) return cone_chord(ray, quadric);
  const Vec3 across = ray.direction - dot(ray.direction, quadric.axis) * quadric.axis;
  const Vec3 from_axis = offset - dot(offset, quadric.axis) * quadric.axis;
  const double a = dot(across, across), c = dot(from_axis, from_axis) - r2;
  if (a == 0) return c <= 0 ? std::optional(Chord{-kInfinity, kInfinity}) : std::nullopt;
  return between_roots(a, dot(from_axis, across), c);
}

Vec3 normal_at(const Quadric& quadric, Vec3 point) {
  const Vec3 offset = point - quadric.point;
  if (quadric.kind == Quadric::Kind::sphere) return (1 / norm(offset)) * offset;
  const Vec3 radial = offset - dot(offset, quadric.axis) * quadric.axis;
  const double length = norm(radial);
  if (!(length > 0)) return -1.0 * quadric.axis;
  const Vec3 outward = (1 / length) * radial;
  if (quadric.kind == Quadric::Kind::cylinder) return outward;
  const Vec3 normal = outward - quadric.tangent * quadric.axis;
  return (1 / norm(normal)) * normal;
}

double arch_radius(const Opening& opening) {
  const double half = (opening.right - opening.left) / 2;
  return (half * half + opening.rise * opening.rise) / (2 * opening.rise);
}

bool contains(const Opening& opening, FlatPoint p) {
  if (!(p.x > opening.left && p.x < opening.right && p.y > opening.bottom)) return false;
  if (p.y < opening.springing) return true;
  if (!(opening.rise > 0) || p.y > opening.springing + opening.rise) return false;
  if (opening.head != ArchHead::circular) return below_arch(opening, p);
  const double radius = arch_radius(opening);
  const double dx = p.x - (opening.left + opening.right) / 2, dy = p.y - (opening.springing + opening.rise - radius);
  return dx * dx + dy * dy < radius * radius;
}

std::optional<PartHit> meet(const Ray& ray, const Part& part, double from) {
  if (const auto* solid = std::get_if<Solid>(&part)) return meet_solid(ray, *solid, from);
  if (const auto* panel = std::get_if<Panel>(&part)) return meet_panel(ray, *panel, from);
  if (const auto* sheet = std::get_if<Sheet>(&part)) return meet_sheet(ray, *sheet, from);
  if (const auto* triangle = std::get_if<Facet>(&part)) return meet_facet(ray, *triangle, from);
  return meet_shell(ray, std::get<Shell>(part), from);
}

Box3<Vec3> bounds_of(const Part& part) {
  if (const auto* solid = std::get_if<Solid>(&part)) return solid->bounds;
  if (const auto* shell = std::get_if<Shell>(&part)) return shell->bounds;
  if (const auto* sheet = std::get_if<Sheet>(&part))
    return bounds_of_panel(sheet->panel, sheet->form.most() + sheet->relief.most() + kOverlap);
  if (const auto* t = std::get_if<Facet>(&part)) return bounds_of_points(std::array{t->a, t->b, t->c});
  const auto& panel = std::get<Panel>(part);
  std::vector<Vec3> corners;
  for (FlatPoint p : panel.ring) corners.push_back(panel.origin + p.x * panel.u + p.y * panel.v);
  return bounds_of_points(corners);
}

std::optional<Facet> facet(Vec3 a, Vec3 b, Vec3 c, SurfaceId surface) {
  const Vec3 area = cross(b - a, c - a);
  const double length = norm(area);
  if (!(length > 0)) return std::nullopt;
  return Facet{a, b, c, (1 / length) * area, surface};
}

Solid prism(std::span<const Vec3> ring, Vec3 sweep, SurfaceId surface) {
  assert(ring.size() >= 3 && ring.size() + 2 <= Solid::kMaxPlanes);
  Solid solid;
  const Vec3 area = doubled_area(ring);
  const double side = dot(area, sweep) > 0 ? 1 : -1;  // side of the sweep, seen from the ring
  for (std::size_t i = 0; i < ring.size(); ++i)
    add_plane(solid, side * cross(ring[(i + 1) % ring.size()] - ring[i], sweep), ring[i]);
  add_plane(solid, -side * area, ring[0]);
  add_plane(solid, side * area, ring[0] + sweep);
  solid.surfaces.fill(surface);
  solid.bounds = bounds_of_points(ring);
  for (Vec3 p : ring) solid.bounds.add(p + sweep);
  return solid;
}

Solid cylinder(Vec3 base, Vec3 axis, double length, double radius, SurfaceId surface) {
  Solid solid;
  const Vec3 top = base + length * axis, extent = disc_extent(axis, radius);
  add_plane(solid, -1.0 * axis, base);
  add_plane(solid, axis, top);
  solid.quadric = {Quadric::Kind::cylinder, base, axis, radius, 0};
  solid.surfaces.fill(surface);
  solid.bounds = bounds_of_points(std::array{base - extent, base + extent, top - extent, top + extent});
  return solid;
}

Solid cone(Vec3 apex, Vec3 axis, double from, double to, double tangent, SurfaceId surface) {
  Solid solid;
  const Vec3 near_end = apex + from * axis, far_end = apex + to * axis;
  const Vec3 narrow = disc_extent(axis, from * tangent), wide = disc_extent(axis, to * tangent);
  add_plane(solid, -1.0 * axis, near_end);
  add_plane(solid, axis, far_end);
  solid.quadric = {Quadric::Kind::cone, apex, axis, 0, tangent};
  solid.surfaces.fill(surface);
  solid.bounds = bounds_of_points(std::array{near_end - narrow, near_end + narrow, far_end - wide, far_end + wide});
  return solid;
}

Solid sphere(Vec3 centre, double radius, SurfaceId surface) {
  Solid solid;
  solid.quadric = {Quadric::Kind::sphere, centre, {0, 0, 1}, radius, 0};
  solid.surfaces.fill(surface);
  const Vec3 extent{radius, radius, radius};
  solid.bounds = {centre - extent, centre + extent};
  return solid;
}

void cut(Solid& solid, const Plane& plane, SurfaceId surface) {
  assert(solid.plane_count < Solid::kMaxPlanes);
  solid.surfaces[solid.plane_count + 1] = solid.surfaces[solid.plane_count];  // the surface of the quadric stays last
  solid.surfaces[solid.plane_count] = surface;
  solid.planes[solid.plane_count++] = plane;
}

}  // namespace ilot::scan
