// SPDX-License-Identifier: Apache-2.0
// Places, planes and areas. Coordinates are those of the coordinate reference system (CRS) of the clouds and in its
// units, mostly metres; z points up. Plain values without invariants.
//
//   const ilot::Plane level{{0, 0, 1}, -12.5};                            // z = 12.5
//   const double above = ilot::signed_distance(level, {700000, 6600000, 15});  // 2.5
#pragma once
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace ilot {

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3 a) {
  return std::sqrt(dot(a, a));
}

// n . p + d = 0, n of unit length; the signed distance of p is n . p + d.
struct Plane {
  Vec3 n{0, 0, 1};
  double d = 0;
};

inline double signed_distance(const Plane& plane, Vec3 p) {
  return dot(plane.n, p) + plane.d;
}

// A closed ring in plan; the last vertex is not repeated.
using AreaRing = std::vector<std::array<double, 2>>;

// A part of the ground. Without rings it is the closed box. With rings it is their union by the even-odd rule (holes
// are rings as well), and the box is that of their vertices.
struct Area {
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;  // units of the CRS
  std::vector<AreaRing> rings;

  // A point on an edge belongs to one of the two areas that share the edge. O(vertices), exact for points
  // farther from an edge than rounding of its interpolation.
  bool contains(double x, double y) const;
};

// Points in memory: three arrays of one length, not owned, finite. What neighbours.h, clusters.h, plane_search.h and
// rasters.h take. They round the points to a lattice of whole steps around the middle of their box, 2^22 steps along
// its longest side, and are exact from there on. So a point moves by at most half a step along each axis, 0.87 steps in
// all.
struct PointArrays {
  std::span<const double> x, y, z;
};

// The step that is used where none is given: the smallest 1, 2 or 5 times a power of ten of which 2^22 cover the
// longest side of the box: 0.0001 up to 419 m, 0.001 up to 4194 m. Coordinates that are whole multiples of it stay as
// they are. O(n). Error (usage) for arrays of different lengths, coordinates that are not finite, or no points.
double lattice_step(const PointArrays& points);

}  // namespace ilot
