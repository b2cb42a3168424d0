// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/facade_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/drawings/facade_plan.h"
#include "kernels/outlines/ear_clipping.h"
#include "kernels/outlines/simple_ring.h"

namespace ilot {
namespace {

constexpr double kSameCorner = 1e-3, kLeastDepth = 1e-3;  // metres
constexpr double kFarthest = 1e8;                         // CRS units, from zero to the facade's origin
constexpr double kLattice = 1e-4;                         // metres, for the test of simplicity

// Removes corners that a validator would treat as one with another.
std::vector<FlatPoint> clean_ring(const std::vector<FlatPoint>& ring) {
  const auto near = [](FlatPoint a, FlatPoint b) {
    return std::abs(a.x - b.x) < kSameCorner && std::abs(a.y - b.y) < kSameCorner;
  };
  std::vector<FlatPoint> clean;
  for (const FlatPoint& p : ring)
    if (clean.empty() || !near(clean.back(), p)) clean.push_back(p);
  while (clean.size() > 1 && near(clean.front(), clean.back())) clean.pop_back();
  return clean;
}

// The test works on a lattice of 0.1 mm from the first corner.
bool is_simple(const std::vector<FlatPoint>& ring) {
  std::vector<Point2> lattice;
  for (const FlatPoint& p : ring) {
    const double x = (p.x - ring[0].x) / kLattice, y = (p.y - ring[0].y) / kLattice;
    if (!(std::abs(x) < kMaxPlaneCoordinate && std::abs(y) < kMaxPlaneCoordinate)) return false;
    lattice.push_back(lattice_point({x, y}, 1));
  }
  return ring.size() >= 3 && is_simple_ring(lattice);
}

// Far from zero a tenth of a millimetre is lost, and corners coincide.
bool is_on_earth(const Facade& facade) {
  const Vec3 o = facade.origin;
  return std::abs(o.x) < kFarthest && std::abs(o.y) < kFarthest && std::abs(o.z) < kFarthest;
}

// Checks a body that other software wrote: corners may coincide, and faces without a normal have no triangles.
bool is_sound(const FacadeBody& body) {
  constexpr double kLeastEdge = 1e-6, kLeastArea = 1e-9;  // CRS units
  for (const Vec3& p : body.vertices)
    if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest)) return false;
  for (const auto& face : body.faces) {
    const Vec3 a = body.vertices[face[0]];
    Vec3 normal{0, 0, 0};
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      normal = normal + cross(body.vertices[face[i]] - a, body.vertices[face[i + 1]] - a);
    if (norm(body.vertices[face[1]] - a) < kLeastEdge || norm(normal) < kLeastArea) return false;
  }
  return !body.faces.empty();
}

FacadeSolid prism(const std::vector<FlatPoint>& ring, double back, double front, const Facade& facade, double m) {
  FacadeSolid solid;
  const auto n = static_cast<std::uint32_t>(ring.size());
  for (const double out : {back, front})
    for (const FlatPoint& p : ring)
      solid.vertices.push_back(facade.origin + (p.x / m) * facade.right + (p.y / m - facade.origin.z) * facade.up +
                               out * facade.out);
  std::vector<std::uint32_t> inner, outer;
  for (std::uint32_t i = 0; i < n; ++i) {
    inner.push_back(n - 1 - i);
    outer.push_back(n + i);
  }
  solid.faces = {std::move(outer), std::move(inner)};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    solid.faces.push_back({i, next, n + next, n + i});
  }
  return solid;
}

std::string word(const std::string& text) {
  std::string word;
  for (const char c : text)
    word += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
  return word;
}

// Returns the triangles of a face in its own plane: coordinates along its first edge and across it.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& face,
                                                       const std::vector<Vec3>& vertices) {
  const Vec3 origin = vertices[face[0]];
  Vec3 normal{0, 0, 0};
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    normal = normal + cross(vertices[face[i]] - origin, vertices[face[i + 1]] - origin);
  const Vec3 along = vertices[face[1]] - origin, u = (1 / norm(along)) * along;
  const Vec3 v = cross((1 / norm(normal)) * normal, u);
  std::vector<FlatPoint> flat;
  std::vector<std::uint32_t> ring;
  for (const std::uint32_t i : face) {
    ring.push_back(static_cast<std::uint32_t>(flat.size()));
    flat.push_back({dot(vertices[i] - origin, u), dot(vertices[i] - origin, v)});
  }
  std::vector<std::array<std::uint32_t, 3>> triangles =
      triangulate(flat, std::vector<std::vector<std::uint32_t>>{ring});
  for (auto& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = face[corner];
  return triangles;
}

std::string place(Vec3 p) {
  return fmt::format("{} {} {}", decimal(p.x, 4), decimal(p.y, 4), decimal(p.z, 4));
}

}  // namespace

std::vector<FacadeSolid> facade_solids(const Facade& facade, double metres_per_unit) {
  std::vector<FacadeSolid> solids;
  for (const FacadeElement& e : facade.elements) {
    if (e.status == DrawnStatus::occluded || std::abs(e.depth_m) < kLeastDepth || e.kind == "outline" ||
        e.kind == "dormer")
      continue;
    // The body of a leaf within the reveal, or half open, is not known: its thickness was not seen.
    if (e.kind == "shutter" && (e.depth_m < 0 || e.reason == "half open")) continue;
    if (e.region == FacadeRegion::irregularity && !e.body.vertices.empty()) continue;
    if (e.body.closed && is_on_earth(facade) && is_sound(e.body)) {
      solids.push_back({e.id, e.kind, e.body.vertices, e.body.faces});
      continue;
    }
    const std::vector<FlatPoint> ring = clean_ring(chords_of(flat_element(facade, e, metres_per_unit)));
    if (!is_simple(ring) || !is_on_earth(facade)) continue;
    const double own = distance_from_wall(facade, e), depth = e.depth_m / metres_per_unit;
    const bool from_end = !e.opening && std::abs(own - depth) < std::abs(own);  // its ring is that of its front
    const double other = from_end ? own - depth : own + depth;
    FacadeSolid solid = prism(ring, std::min(own, other), std::max(own, other), facade, metres_per_unit);
    solid.element = e.id;
    solid.kind = e.kind;
    solids.push_back(std::move(solid));
  }
  return solids;
}

std::vector<FacadeSolid> facade_meshes(const Facade& facade) {
  std::vector<FacadeSolid> meshes;
  for (const FacadeElement& e : facade.elements)
    if (e.region == FacadeRegion::irregularity && !e.body.closed && is_on_earth(facade) && is_sound(e.body))
      meshes.push_back({e.id, e.kind, e.body.vertices, e.body.faces});
  return meshes;
}

std::string solids_obj(const std::vector<FacadeSolid>& solids) {
  std::string obj;
  std::size_t before = 1;
  for (const FacadeSolid& solid : solids) {
    obj += fmt::format("o element-{}-{}\n", solid.element, word(solid.kind));
    for (const Vec3& v : solid.vertices) obj += "v " + place(v) + "\n";
    for (const auto& face : solid.faces) {
      obj += "f";
      for (const std::uint32_t i : face) obj += fmt::format(" {}", before + i);
      obj += "\n";
    }
    before += solid.vertices.size();
  }
  return obj;
}

std::string solids_stl(const std::vector<FacadeSolid>& solids) {
  std::string stl;
  for (const FacadeSolid& solid : solids) {
    const std::string name = fmt::format("element-{}-{}", solid.element, word(solid.kind));
    stl += "solid " + name + "\n";
    for (const auto& face : solid.faces) {
      for (const auto& [a, b, c] : triangles_of(face, solid.vertices)) {
        const Vec3 p = solid.vertices[a], q = solid.vertices[b], r = solid.vertices[c];
        const Vec3 normal = cross(q - p, r - p);
        const double length = norm(normal);
        const Vec3 unit = length > 0 ? (1 / length) * normal : Vec3{0, 0, 0};
        stl += fmt::format(" facet normal {} {} {}\n  outer loop\n", decimal(unit.x, 6), decimal(unit.y, 6),
                           decimal(unit.z, 6));
        for (const Vec3& corner : {p, q, r}) stl += "   vertex " + place(corner) + "\n";
        stl += "  endloop\n endfacet\n";
      }
    }
    stl += "endsolid " + name + "\n";
  }
  return stl;
}

}  // namespace ilot
