// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/topology.h"

#include <algorithm>

namespace ilot {
namespace {

bool arrays_fit(const Triangulation& t, std::size_t points) {
  if (t.corner.size() % 3 != 0 || t.twin.size() != t.corner.size() || t.duplicates.size() > points) return false;
  return std::all_of(t.corner.begin(), t.corner.end(), [&](std::uint32_t v) { return v < points; }) &&
         std::all_of(t.twin.begin(), t.twin.end(),
                     [&](std::uint32_t e) { return e == kNoEdge || e < t.corner.size(); });
}

bool twins_agree(const Triangulation& t) {
  for (std::uint32_t e = 0; e < t.twin.size(); ++e) {
    const std::uint32_t other = t.twin[e];
    if (other == kNoEdge) continue;
    if (t.twin[other] != e || t.corner[other] != t.corner[next_edge(e)] || t.corner[next_edge(other)] != t.corner[e])
      return false;
  }
  return true;
}

bool all_turn_left(const Triangulation& t, std::span<const Point2> points) {
  for (std::size_t i = 0; i < t.corner.size(); i += 3)
    if (orient2d(points[t.corner[i]], points[t.corner[i + 1]], points[t.corner[i + 2]]) <= 0) return false;
  return true;
}

bool hull_is_convex(const Triangulation& t, std::span<const Point2> points, std::size_t hull_edges) {
  const auto start = static_cast<std::uint32_t>(std::find(t.twin.begin(), t.twin.end(), kNoEdge) - t.twin.begin());
  std::size_t seen = 0;
  std::uint32_t e = start;
  do {
    const std::uint32_t next = next_hull_edge(t, e);
    if (orient2d(points[t.corner[e]], points[t.corner[next]], points[t.corner[next_edge(next)]]) < 0) return false;
    e = next;
  } while (++seen <= hull_edges && e != start);
  return seen == hull_edges;
}

bool on_one_line(std::span<const Point2> points) {
  std::size_t i = 0, k = 0;
  while (i < points.size() && points[i] == points[0]) ++i;
  while (i < points.size() && k < points.size() && orient2d(points[0], points[i], points[k]) == 0) ++k;
  return i == points.size() || k == points.size();
}

}  // namespace

TopologyFault check_topology(const Triangulation& t, std::span<const Point2> points) {
  if (!arrays_fit(t, points.size())) return TopologyFault::kArrays;
  if (!twins_agree(t)) return TopologyFault::kTwins;
  if (!all_turn_left(t, points)) return TopologyFault::kOrientation;
  if (t.corner.empty()) return on_one_line(points) ? TopologyFault::kNone : TopologyFault::kVertices;
  const auto hull = static_cast<std::size_t>(std::count(t.twin.begin(), t.twin.end(), kNoEdge));
  if (hull < 3 || !hull_is_convex(t, points, hull)) return TopologyFault::kHull;
  std::vector<bool> used(points.size());
  for (const std::uint32_t v : t.corner) used[v] = true;
  const auto vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  if (vertices + t.duplicates.size() != points.size()) return TopologyFault::kVertices;
  for (const auto& [left_out, kept] : t.duplicates)
    if (left_out >= points.size() || kept >= left_out || used[left_out] || !used[kept] ||
        points[left_out] != points[kept])
      return TopologyFault::kVertices;
  return t.triangles() == 2 * vertices - 2 - hull ? TopologyFault::kNone : TopologyFault::kVertices;
}

bool is_delaunay(const Triangulation& t, std::span<const Point2> points) {
  for (std::uint32_t e = 0; e < t.twin.size(); ++e)
    if (t.twin[e] > e && t.twin[e] != kNoEdge &&
        in_circle(points[t.corner[e]], points[t.corner[next_edge(e)]], points[t.corner[previous_edge(e)]],
                  points[far_corner(t, e)]))
      return false;
  return true;
}

}  // namespace ilot
