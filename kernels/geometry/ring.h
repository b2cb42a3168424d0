// SPDX-License-Identifier: Apache-2.0
// Rings are closed lines of corners. The last corner leads back to the first, which is not repeated. All functions are
// O(corners).
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// Twice the signed area of the ring with the corners corner(0) to corner(count - 1). It is positive when the ring turns
// left. It is the sum over the triangles from the first corner, in this order. It is 0 for fewer than three corners.
template <class Sum, class Corner>
Sum doubled_area(std::size_t count, const Corner& corner) {
  Sum sum = 0;
  for (std::size_t i = 1; i + 1 < count; ++i) sum += orient2d(corner(0), corner(i), corner(i + 1));
  return sum;
}

// The result is exact for rings within kMaxPlaneCoordinate.
inline __int128 doubled_area(std::span<const Point2> ring) {
  return doubled_area<__int128>(ring.size(), [&](std::size_t i) { return ring[i]; });
}

inline double doubled_area(std::span<const FlatPoint> ring) {
  return doubled_area<double>(ring.size(), [&](std::size_t i) { return ring[i]; });
}

// Area vector of a flat ring in space. Its length is twice the area. It points along the normal to the side from which
// the ring runs counter-clockwise.
inline Vec3 doubled_area(std::span<const Vec3> ring) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum = sum + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return sum;
}

// Whether the ray from p towards +x crosses the edge a-b. An edge includes its lower end but not its upper one. A point
// on the edge counts as right of it. The result for b-a is the same, so exactly one of the regions that tile the plane
// contains p. It is the sign of one determinant, which is exact for Point2 and rounded for FlatPoint.
template <class Point>
bool ray_crosses(Point p, Point a, Point b) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  return (a.y > b.y ? orient2d(b, a, p) : orient2d(a, b, p)) > 0;
}

// The same test by the place where the edge passes the height of p, interpolated from a. It rounds in another way than
// ray_crosses. Near the edge the result may differ from the result for b-a.
inline bool ray_crosses_by_share(FlatPoint p, FlatPoint a, FlatPoint b) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
}

// Whether the ring contains p by the even-odd rule of ray_crosses.
inline bool contains(std::span<const Point2> ring, Point2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) inside ^= ray_crosses(p, ring[i], ring[(i + 1) % ring.size()]);
  return inside;
}

// The same test by ray_crosses_by_share, with each edge taken from its first corner on.
inline bool contains_by_share(std::span<const FlatPoint> ring, FlatPoint p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) inside ^= ray_crosses_by_share(p, ring[i], ring[(i + 1) % ring.size()]);
  return inside;
}

inline void add_ring(std::span<const FlatPoint> ring, std::vector<FlatEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

}  // namespace ilot
