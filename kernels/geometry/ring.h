// SPDX-License-Identifier: Apache-2.0
// Rings: closed lines of corners, the last of which leads back to the first and is not repeated. All O(corners).
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// Twice the signed area of a ring whose corners corner(0) to corner(count - 1) are: positive when it turns left. The
// sum of the triangles from the first corner, in this order. 0 for fewer than three corners.
template <class Sum, class Corner>
Sum doubled_area(std::size_t count, const Corner& corner) {
  Sum sum = 0;
  for (std::size_t i = 1; i + 1 < count; ++i) sum += orient2d(corner(0), corner(i), corner(i + 1));
  return sum;
}

// Exact: rings within kMaxPlaneCoordinate.
inline __int128 doubled_area(std::span<const Point2> ring) {
  return doubled_area<__int128>(ring.size(), [&](std::size_t i) { return ring[i]; });
}

inline double doubled_area(std::span<const FlatPoint> ring) {
  return doubled_area<double>(ring.size(), [&](std::size_t i) { return ring[i]; });
}

// Of a flat ring in space: as long as twice its area, along its normal, to whose side it runs counter-clockwise.
inline Vec3 doubled_area(std::span<const Vec3> ring) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum = sum + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return sum;
}

// Whether the ray from p towards +x crosses the edge a-b. An edge owns its lower end, not its upper one, and what lies
// on it is to its right. The answer is that for b-a, so that of regions which tile the plane one holds p. By the sign
// of one determinant: exact for Point2, rounded for FlatPoint.
template <class Point>
bool ray_crosses(Point p, Point a, Point b) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  return (a.y > b.y ? orient2d(b, a, p) : orient2d(a, b, p)) > 0;
}

// The same by the place at which the edge passes the height of p, interpolated from a. It rounds in another way than
// ray_crosses, and near the edge the answer may differ from that for b-a.
inline bool ray_crosses_by_share(FlatPoint p, FlatPoint a, FlatPoint b) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
}

// Whether p lies inside by the even-odd rule of ray_crosses.
inline bool contains(std::span<const Point2> ring, Point2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) inside ^= ray_crosses(p, ring[i], ring[(i + 1) % ring.size()]);
  return inside;
}

// The same by ray_crosses_by_share, each edge from its first corner on.
inline bool contains_by_share(std::span<const FlatPoint> ring, FlatPoint p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) inside ^= ray_crosses_by_share(p, ring[i], ring[(i + 1) % ring.size()]);
  return inside;
}

// Appends the edges of a ring.
inline void add_ring(std::span<const FlatPoint> ring, std::vector<FlatEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

}  // namespace ilot
