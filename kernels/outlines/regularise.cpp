// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/regularise.h"

#include <algorithm>
#include <cmath>

#include "kernels/delaunay/thinning.h"
#include "kernels/outlines/outline_sides.h"
#include "kernels/outlines/simple_ring.h"

namespace ilot {
namespace {

using Loop = std::vector<Point2>;

// Choice: farther corners are spikes of nearly parallel edges.
constexpr double kFarCorner = 4;  // tolerances; a corner farther from where the edges part is not one

FlatPoint foot(const OutlineSide& s, FlatPoint p) {
  return s.centre + dot(p - s.centre, s.direction) * s.direction;
}

// Adds the corners between a side and the next one: one where their lines meet, otherwise two where both leave the
// boundary.
void add_corners(const OutlineSide& a, const OutlineSide& b, double tolerance, double outwards,
                 std::vector<FlatPoint>& corners) {
  const FlatPoint part = 0.5 * (a.to + b.from);
  FlatPoint at;
  if (!parallel(a, b) && meet(a, b, at) &&
      std::sqrt(dot(at - part, at - part)) <= kFarCorner * tolerance + 2 * outwards)
    return corners.push_back(at);
  corners.push_back(foot(a, part));
  corners.push_back(foot(b, part));
}

// Returns how far beyond its points an edge is. Points that end anywhere within a step of the edge scatter by the step
// over the root of 12 and are half a step inside on average. Points that do not scatter, such as those of walls, are on
// the edge.
double beyond_points(double scatter2, double most) {
  return std::min(most, std::sqrt(3 * scatter2));
}

// Returns the scatter for sides with too few points of their own, which is that of all other sides.
double common_scatter2(const std::vector<OutlineSide>& sides) {
  double sum = 0, whole = 0;
  for (const OutlineSide& s : sides) {
    if (s.scatter2 < 0) continue;
    sum += s.length * s.scatter2;
    whole += s.length;
  }
  return whole > 0 ? sum / whole : HUGE_VAL;
}

Loop ring_of(std::vector<OutlineSide> sides, double tolerance, double outwards) {
  const double common = common_scatter2(sides);
  for (OutlineSide& s : sides) {
    const double out = beyond_points(s.scatter2 < 0 ? common : s.scatter2, outwards);
    s.centre = s.centre + out * FlatPoint{s.direction.y, -s.direction.x};
  }
  std::vector<FlatPoint> corners;
  for (std::size_t i = 0; i < sides.size(); ++i)
    add_corners(sides[i], sides[(i + 1) % sides.size()], tolerance, outwards, corners);
  Loop ring;
  for (const FlatPoint c : corners) {
    if (!(std::abs(c.x) < kMaxPlaneCoordinate && std::abs(c.y) < kMaxPlaneCoordinate)) return {};
    const Point2 p = lattice_point(c, 1);
    if (ring.empty() || p != ring.back()) ring.push_back(p);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

// Moves the rings relative to their first vertex, so that doubles stay small at every place.
std::vector<Loop> moved(std::span<const Loop> rings, std::int32_t dx, std::int32_t dy) {
  std::vector<Loop> result(rings.begin(), rings.end());
  for (Loop& ring : result)
    for (Point2& p : ring) p = {p.x + dx, p.y + dy};
  return result;
}

std::vector<Loop> thinned(std::span<const Loop> rings, double tolerance) {
  std::vector<Point2> points;
  Polygons polygons;
  polygons.count = 1;
  for (const Loop& ring : rings) {
    polygons.rings.push_back({static_cast<std::uint32_t>(points.size()), static_cast<std::uint32_t>(ring.size()), 0});
    for (const Point2 p : ring) {
      polygons.vertices.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
  }
  const Polygons thin = thin_rings(polygons, points, tolerance);
  std::vector<Loop> result;
  for (const auto& r : thin.rings) {
    Loop& ring = result.emplace_back();
    for (std::uint32_t i = 0; i < r.count; ++i) ring.push_back(points[thin.vertices[r.first + i]]);
  }
  return result;
}

// Holes that shrink to nothing when edges move out are left out.
std::vector<Loop> outline_of(const std::vector<std::vector<OutlineSide>>& sides, double tolerance, double outwards) {
  std::vector<Loop> result;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    Loop ring = ring_of(sides[i], tolerance, outwards);
    if (i > 0 && (ring.size() < 3 || doubled_area(ring) >= 0)) continue;
    result.push_back(std::move(ring));
  }
  return result;
}

}  // namespace

std::vector<std::vector<Point2>> regularise(std::span<const std::vector<Point2>> rings,
                                            const RegulariseParams& params) {
  if (rings.empty() || rings[0].size() < 3) return {};
  const Point2 origin = rings[0][0];
  const std::vector<Loop> local = moved(rings, -origin.x, -origin.y);
  const auto sides = sides_of(local, params.tolerance);
  for (const double outwards : {params.outwards, 0.0}) {
    const std::vector<Loop> outline = outline_of(sides, params.tolerance, outwards);
    if (is_simple_polygon(outline)) return moved(outline, origin.x, origin.y);
  }
  return moved(thinned(local, params.tolerance), origin.x, origin.y);
}

}  // namespace ilot
