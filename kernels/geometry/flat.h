// SPDX-License-Identifier: Apache-2.0
// Points and edges of a plane in doubles, for measuring. Exact geometry in the plane uses lattice points
// (kernels/geometry/point2.h).
#pragma once
#include <algorithm>
#include <cmath>

namespace ilot {

struct FlatPoint {
  double x = 0, y = 0;
};

inline FlatPoint operator+(FlatPoint a, FlatPoint b) {
  return {a.x + b.x, a.y + b.y};
}
inline FlatPoint operator-(FlatPoint a, FlatPoint b) {
  return {a.x - b.x, a.y - b.y};
}
inline FlatPoint operator*(double s, FlatPoint a) {
  return {s * a.x, s * a.y};
}
inline double dot(FlatPoint a, FlatPoint b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(FlatPoint a, FlatPoint b) {
  return a.x * b.y - a.y * b.x;
}
inline double norm(FlatPoint a) {
  return std::sqrt(dot(a, a));
}
inline double squared_distance(FlatPoint a, FlatPoint b) {
  return dot(b - a, b - a);
}
inline double distance(FlatPoint a, FlatPoint b) {
  return norm(b - a);
}

// Twice the signed area of the triangle, which is positive when a, b, c turn left. The value is rounded, so its sign is
// not exact.
inline double orient2d(FlatPoint a, FlatPoint b, FlatPoint c) {
  return cross(b - a, c - a);
}

struct FlatEdge {
  FlatPoint a, b;
};

// Squared distance from the nearest point of the closed edge, or from its end `a` when the edge has no length.
inline double squared_distance(FlatPoint p, const FlatEdge& edge) {
  const FlatPoint along = edge.b - edge.a, from = p - edge.a;
  const double length2 = dot(along, along);
  const double share = length2 > 0 ? std::clamp(dot(from, along) / length2, 0.0, 1.0) : 0;
  const FlatPoint gap = from - share * along;
  return dot(gap, gap);
}

}  // namespace ilot
