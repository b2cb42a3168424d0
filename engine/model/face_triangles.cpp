// SPDX-License-Identifier: Apache-2.0
#include "engine/model/face_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/core/eigen3.h"
#include "kernels/delaunay/constrained.h"
#include "kernels/outlines/simple_ring.h"

namespace ilot {
namespace {

constexpr double kWidest = 1 << 28;  // steps; of a face on its own lattice

// Components that are only rounding noise become zero, so that horizontal and vertical planes along the axes keep exact
// coordinates.
Vec3 cleaned(Vec3 n) {
  constexpr double kNoise = 1e-12;
  for (double* c : {&n.x, &n.y, &n.z})
    if (std::abs(*c) < kNoise) *c = 0;
  return (1 / norm(n)) * n;
}

// Returns the triangles inside, sorted by their corners from the last one on, which is the order of the rings. The
// order matters when a shell is not a manifold: the first triangle at an edge stays, later ones are faulty.
std::vector<std::size_t> by_last_corner(const Triangulation& t, const std::vector<std::uint8_t>& inside) {
  std::vector<std::pair<TriangleCorners, std::size_t>> order;
  for (std::size_t i = 0; i < t.triangles(); ++i) {
    if (!inside[i]) continue;
    TriangleCorners c{t.corner[3 * i], t.corner[3 * i + 1], t.corner[3 * i + 2]};
    std::sort(c.rbegin(), c.rend());
    order.push_back({c, i});
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> triangles;
  for (const auto& [corners, i] : order) triangles.push_back(i);
  return triangles;
}

// Does the same for the most common face, four corners in one ring. It finds the diagonal that is inside; if both are,
// it takes the one that is Delaunay.
std::vector<TriangleCorners> quadrangle_triangles(const std::vector<Point2>& p,
                                                  const std::vector<std::uint32_t>& ring) {
  const bool left = doubled_area(p) > 0;
  const auto turns = [&](std::size_t a, std::size_t b, std::size_t c) {
    return left ? orient2d(p[a], p[b], p[c]) > 0 : orient2d(p[a], p[c], p[b]) > 0;
  };
  const bool even = turns(0, 1, 2) && turns(0, 2, 3), odd = turns(0, 1, 3) && turns(1, 2, 3);
  const auto round = [&] { return left ? in_circle(p[0], p[1], p[2], p[3]) : in_circle(p[0], p[2], p[1], p[3]); };
  if (odd && (!even || round())) return {{ring[0], ring[1], ring[3]}, {ring[1], ring[2], ring[3]}};
  return {{ring[0], ring[1], ring[2]}, {ring[0], ring[2], ring[3]}};
}

// Corners at one place on the plane (rings may touch in a vertex) become one.
std::vector<TriangleCorners> constrained_triangles(const std::vector<std::vector<Point2>>& flat,
                                                   const FaceRings& rings) {
  std::vector<Point2> points;
  std::vector<std::uint32_t> corners;
  std::vector<VertexPair> segments;
  const bool turned = doubled_area(flat[0]) < 0;
  for (std::size_t r = 0; r < flat.size(); ++r) {
    const auto first = static_cast<std::uint32_t>(points.size()), n = static_cast<std::uint32_t>(flat[r].size());
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = first + i, b = first + (i + 1) % n;
      segments.push_back(turned ? VertexPair{b, a} : VertexPair{a, b});
      points.push_back(flat[r][i]);
      corners.push_back(rings[r][i]);
    }
  }
  Triangulation t = delaunay(points);
  for (const auto& [twice, kept] : t.duplicates) {
    for (VertexPair& s : segments) {
      if (s.first == twice) s.first = kept;
      if (s.second == twice) s.second = kept;
    }
  }
  const Constraints constraints = insert_segments(t, points, segments);
  const std::vector<std::uint8_t> inside = triangles_inside(t, constraints, segments);
  std::vector<TriangleCorners> out;
  for (const std::size_t i : by_last_corner(t, inside)) {
    TriangleCorners c{corners[t.corner[3 * i]], corners[t.corner[3 * i + 1]], corners[t.corner[3 * i + 2]]};
    if (turned) std::swap(c[1], c[2]);
    out.push_back(c);
  }
  return out;
}

}  // namespace

Vec3 offset(const LatticeVertices& v, std::uint32_t i, Index3 from) {
  const Index3 p = v.points[i];
  return v.step *
         Vec3{static_cast<double>(p.x - from.x), static_cast<double>(p.y - from.y), static_cast<double>(p.z - from.z)};
}

FacePlane plane_of(const LatticeVertices& vertices, const FaceRings& rings) {
  FacePlane plane;
  plane.anchor = vertices.points[rings[0][0]];
  std::vector<Vec3> corners;
  for (const auto& ring : rings)
    for (const std::uint32_t i : ring) corners.push_back(offset(vertices, i, plane.anchor));
  for (const Vec3& p : corners) plane.centre = plane.centre + p;
  plane.centre = (1.0 / static_cast<double>(corners.size())) * plane.centre;
  Symmetric3 spread;
  for (const Vec3& corner : corners) {
    const Vec3 p = corner - plane.centre;
    spread.xx += p.x * p.x, spread.xy += p.x * p.y, spread.xz += p.x * p.z;
    spread.yy += p.y * p.y, spread.yz += p.y * p.z, spread.zz += p.z * p.z;
  }
  plane.n = cleaned(eigen_symmetric(spread).vectors[0]);
  const bool level = plane.n.x == 0 && plane.n.y == 0;
  const Vec3 u = level ? Vec3{1, 0, 0} : Vec3{-plane.n.y, plane.n.x, 0};
  plane.u = (1 / norm(u)) * u;
  plane.v = cross(plane.n, plane.u);
  return plane;
}

double farthest_from(const FacePlane& plane, const LatticeVertices& vertices, const FaceRings& rings) {
  double farthest = 0;
  for (const auto& ring : rings)
    for (const std::uint32_t i : ring)
      farthest = std::max(farthest, std::abs(dot(plane.n, offset(vertices, i, plane.anchor) - plane.centre)));
  return farthest;
}

std::vector<std::vector<Point2>> flattened(const FacePlane& plane, const LatticeVertices& vertices,
                                           const FaceRings& rings) {
  double widest = 0;
  std::vector<std::vector<std::pair<double, double>>> flat(rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (const std::uint32_t i : rings[r]) {
      const Vec3 p = offset(vertices, i, plane.anchor);
      flat[r].push_back({dot(p, plane.u), dot(p, plane.v)});
      widest = std::max({widest, std::abs(flat[r].back().first), std::abs(flat[r].back().second)});
    }
  }
  double step = vertices.step;
  while (widest > kWidest * step) step *= 10;
  std::vector<std::vector<Point2>> out(rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (const auto& [x, y] : flat[r]) out[r].push_back(lattice_point({x / step, y / step}, 1));
  return out;
}

bool is_one_triangle(const FaceRings& rings) {
  return rings.size() == 1 && rings[0].size() == 3;
}

std::vector<TriangleCorners> triangulate_face(const LatticeVertices& vertices, const FaceRings& rings) {
  if (is_one_triangle(rings)) return {{rings[0][0], rings[0][1], rings[0][2]}};
  const std::vector<std::vector<Point2>> flat = flattened(plane_of(vertices, rings), vertices, rings);
  if (rings.size() == 1 && rings[0].size() == 4) return quadrangle_triangles(flat[0], rings[0]);
  return constrained_triangles(flat, rings);
}

}  // namespace ilot
