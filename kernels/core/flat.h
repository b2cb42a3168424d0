// SPDX-License-Identifier: Apache-2.0
// Points and edges of a plane in doubles, for measuring. Exact geometry of the plane has lattice points of its own
// (kernels/delaunay/predicates.h).
#pragma once

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

struct FlatEdge {
  FlatPoint a, b;
};

}  // namespace ilot
