// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/boundary_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/compare/planes/plane_frame.h"
#include "engine/flat_area.h"
#include "kernels/geometry/closest.h"
#include "kernels/outlines/edge_cells.h"

namespace ilot {
namespace {

constexpr double kSnap = 0.001;  // metres within which corners of neighbouring polygons are one

FlatFrame frame_of(const TruePlane& plane) {
  return plane_frame(plane.plane.n, plane.polygons[0].ring[0]);
}

double distance_to_edges(FlatPoint p, std::span<const FlatEdge> edges) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : edges) {
    const Vec3 gap = Vec3{p.x, p.y, 0} - closest_on_segment({p.x, p.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0});
    best = std::min(best, norm(gap));
  }
  return best;
}

}  // namespace

double BoundaryCounts::error() const {
  const std::uint64_t differ = truth + found - 2 * common;
  if (differ == 0) return 0;
  return common == 0 ? std::numeric_limits<double>::infinity()
                     : static_cast<double>(differ) / static_cast<double>(common);
}

void BoundaryCounts::add(const BoundaryCounts& other) {
  truth += other.truth;
  found += other.found;
  common += other.common;
}

std::vector<FlatEdge> true_edges(const TruePlane& plane, double metres_per_unit) {
  if (plane.polygons.empty()) return {};
  const FlatFrame frame = frame_of(plane);
  std::vector<FlatPolygon> polygons;
  for (const TruePolygon& polygon : plane.polygons) {
    polygons.push_back({flattened(polygon.ring, frame), {}});
    for (const Ring3& hole : polygon.holes) polygons.back().holes.push_back(flattened(hole, frame));
  }
  return FlatArea(polygons, kSnap / metres_per_unit).edges();
}

BoundaryCounts boundary_counts(const TruePlane& plane, const BoundaryPoints& points, double metres_per_unit) {
  if (plane.polygons.empty()) return {};
  const FlatFrame frame = frame_of(plane);
  std::vector<FlatPoint> flat;
  for (std::size_t i = 0; i < points.own.size(); ++i)
    if (points.true_point[i]) flat.push_back(frame.flat(points.own[i]));
  const std::vector<std::uint8_t> on_edge = cells_on_edges(flat, true_edges(plane, metres_per_unit));
  BoundaryCounts counts;
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.own.size(); ++i) {
    const bool truth = points.true_point[i] && on_edge[next++];
    counts.truth += truth;
    counts.found += points.marked[i];
    counts.common += truth && points.marked[i];
  }
  return counts;
}

double mean_ring_distance(std::span<const FlatPoint> ring, std::span<const FlatEdge> edges, double step) {
  if (edges.empty() || ring.size() < 2) return 0;
  double weighted = 0, length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const FlatPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const double side = std::hypot(b.x - a.x, b.y - a.y);
    const double samples = std::clamp(std::ceil(side / step), 1.0, 1e5);
    for (double k = 0; k < samples; ++k) {
      const double t = (k + 0.5) / samples;
      weighted += side / samples * distance_to_edges({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, edges);
    }
    length += side;
  }
  return length > 0 ? weighted / length : distance_to_edges(ring[0], edges);
}

}  // namespace ilot
