// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/solid_relation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/validity/planar_cells.h"
#include "kernels/geometry/flat.h"
#include "kernels/meshes/predicates3.h"

namespace ilot {
namespace {

constexpr double kLeastArea = 100.0 * 100.0;  // least area of a piece; steps squared
constexpr double kOnSurface = 2;              // steps

IndexTriangle corners_of(const SolidBoundary& s, std::size_t t) {
  return {s.vertices[s.triangles[t][0]], s.vertices[s.triangles[t][1]], s.vertices[s.triangles[t][2]]};
}

IndexBox box_of(const SolidBoundary& s) {
  IndexBox box = box_of(corners_of(s, 0));
  for (const Index3& p : s.vertices) {
    box.add(p);
  }
  return box;
}

Vec3 real(Index3 p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

Vec3 area_vector(const IndexTriangle& t) {
  return cross(real(t.b) - real(t.a), real(t.c) - real(t.a));
}

// A projection that drops one axis, and the way back onto the plane of a triangle.
struct Drop {
  int axis;
  Vec3 corner, normal;

  FlatPoint flat(Vec3 p) const {
    return axis == 2 ? FlatPoint{p.x, p.y} : axis == 0 ? FlatPoint{p.y, p.z} : FlatPoint{p.z, p.x};
  }
  Vec3 lifted(FlatPoint p) const {
    const auto& [c, n] = std::pair(corner, normal);
    if (axis == 2) return {p.x, p.y, c.z - (n.x * (p.x - c.x) + n.y * (p.y - c.y)) / n.z};
    if (axis == 0) return {c.x - (n.y * (p.x - c.y) + n.z * (p.y - c.z)) / n.x, p.x, p.y};
    return {p.y, c.y - (n.z * (p.x - c.z) + n.x * (p.y - c.x)) / n.y, p.x};
  }
};

// Appends the set where triangle s meets the plane of t: the edges of s on it, or the segment across.
void append_trace(const IndexTriangle& s, const IndexTriangle& t, const Drop& drop, std::vector<FlatEdge>& lines) {
  const std::array<Index3, 3> corner{s.a, s.b, s.c};
  std::array<int, 3> side;
  for (std::size_t i = 0; i < 3; ++i) side[i] = orient3d_sign(t.a, t.b, t.c, corner[i]);
  std::vector<Vec3> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (side[i] == 0 && side[k] == 0) lines.push_back({drop.flat(real(corner[i])), drop.flat(real(corner[k]))});
    if (side[i] == 0) ends.push_back(real(corner[i]));
    if (side[i] * side[k] >= 0) continue;
    const Vec3 p = real(corner[i]), q = real(corner[k]);
    const double above = dot(drop.normal, p - drop.corner), below = dot(drop.normal, q - drop.corner);
    ends.push_back(p + (above / (above - below)) * (q - p));
  }
  if (std::count(side.begin(), side.end(), 0) < 2 && ends.size() == 2)
    lines.push_back({drop.flat(ends[0]), drop.flat(ends[1])});
}

// The side of p relative to the line from a to b, as seen from above. p is moved by an infinitesimal along x and a
// smaller one along y.
int nudged_side(Index3 a, Index3 b, Index3 p) {
  if (const int s = orient2d_sign(a, b, p, 2)) return s;
  if (a.y != b.y) return b.y < a.y ? 1 : -1;
  return b.x > a.x ? 1 : b.x < a.x ? -1 : 0;
}

// Counts crossings of the surface straight above p with their direction: out of the solid +1, into it -1.
bool is_inside(Index3 p, const SolidBoundary& solid) {
  int crossings = 0;
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    const IndexTriangle t = corners_of(solid, i);
    const int side = nudged_side(t.a, t.b, p);
    if (side == 0 || nudged_side(t.b, t.c, p) != side || nudged_side(t.c, t.a, p) != side) continue;
    if (orient3d_sign(t.a, t.b, t.c, p) * side < 0) crossings += side;
  }
  return crossings > 0;
}

bool over_triangle(Vec3 p, const IndexTriangle& t, Vec3 normal) {
  const Vec3 a = real(t.a), b = real(t.b), c = real(t.c);
  const double length = norm(normal);
  const auto left = [&](Vec3 from, Vec3 to) {
    return dot(normal, cross(to - from, p - from)) >= -kOnSurface * length * norm(to - from);
  };
  return std::abs(dot(normal, p - a)) <= kOnSurface * length && left(a, b) && left(b, c) && left(c, a);
}

enum class Place { inside, outside, same, opposite };

Place place_of(Vec3 p, Vec3 normal, const SolidBoundary& solid, const std::vector<std::size_t>& near) {
  for (const std::size_t i : near) {
    const IndexTriangle t = corners_of(solid, i);
    const Vec3 other = area_vector(t);
    if (norm(other) > 0 && over_triangle(p, t, other)) return dot(normal, other) > 0 ? Place::same : Place::opposite;
  }
  return is_inside({std::llround(p.x), std::llround(p.y), std::llround(p.z)}, solid) ? Place::inside : Place::outside;
}

// The places of the pieces of one triangle of a.
std::vector<Place> places_of(const IndexTriangle& t, const SolidBoundary& b, const std::vector<std::size_t>& near) {
  const int axis = widest_axis(t);
  if (axis < 0) return {};
  const Drop drop{axis, real(t.a), area_vector(t)};
  if (near.empty()) return {place_of((1.0 / 3) * (real(t.a) + real(t.b) + real(t.c)), drop.normal, b, near)};
  const std::array<FlatPoint, 3> outline{drop.flat(real(t.a)), drop.flat(real(t.b)), drop.flat(real(t.c))};
  std::vector<FlatEdge> lines;
  for (const std::size_t i : near) append_trace(corners_of(b, i), t, drop, lines);
  std::vector<Place> places;
  for (const FlatPoint& p : cell_points(outline, lines, kLeastArea))
    places.push_back(place_of(drop.lifted(p), drop.normal, b, near));
  return places;
}

struct Places {
  bool inside = false, outside = false, same = false, opposite = false;
};

Places boundary_places(const SolidBoundary& a, const SolidBoundary& b) {
  std::vector<IndexBox> boxes;
  for (std::size_t i = 0; i < b.triangles.size(); ++i) boxes.push_back(box_of(corners_of(b, i)).grown(2));
  Places found;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    const IndexTriangle t = corners_of(a, i);
    const IndexBox box = box_of(t);
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < boxes.size(); ++k)
      if (box.intersects(boxes[k])) near.push_back(k);
    for (const Place place : places_of(t, b, near)) {
      found.inside |= place == Place::inside;
      found.outside |= place == Place::outside;
      found.same |= place == Place::same;
      found.opposite |= place == Place::opposite;
    }
  }
  return found;
}

}  // namespace

SolidRelation relate_solids(const SolidBoundary& a, const SolidBoundary& b) {
  if (!box_of(a).grown(2).intersects(box_of(b))) return {.a_outside_b = true, .b_outside_a = true};
  const Places of_a = boundary_places(a, b), of_b = boundary_places(b, a);
  SolidRelation r;
  r.a_inside_b = of_a.inside, r.a_outside_b = of_a.outside;
  r.b_inside_a = of_b.inside, r.b_outside_a = of_b.outside;
  r.share_same = of_a.same || of_b.same;
  r.share_opposite = of_a.opposite || of_b.opposite;
  return r;
}

}  // namespace ilot
