// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/simple_ring.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ilot {
namespace {

struct RingEdge {
  Point2 a, b;  // left to right
  std::uint32_t number, of;
  std::size_t ring;
};

int turn(Point2 a, Point2 b, Point2 c) {
  const std::int64_t v = orient2d(a, b, c);
  return v > 0 ? 1 : v < 0 ? -1 : 0;
}

// Whether c is between a and b. It must be on the line through them, and a < b.
bool within(Point2 a, Point2 b, Point2 c) {
  return a <= c && c <= b;
}

bool edges_meet(const RingEdge& e, const RingEdge& f) {
  const int p = turn(e.a, e.b, f.a), q = turn(e.a, e.b, f.b), r = turn(f.a, f.b, e.a), s = turn(f.a, f.b, e.b);
  if (p * q < 0 && r * s < 0) return true;
  return (p == 0 && within(e.a, e.b, f.a)) || (q == 0 && within(e.a, e.b, f.b)) || (r == 0 && within(f.a, f.b, e.a)) ||
         (s == 0 && within(f.a, f.b, e.b));
}

// Whether the ring goes back from `corner` over the edge by which it came, or stays at the same place.
bool doubles_back(Point2 before, Point2 corner, Point2 after) {
  if (orient2d(before, corner, after) != 0) return false;
  return (before < corner) == (after < corner);
}

bool are_neighbours(const RingEdge& e, const RingEdge& f) {
  const std::uint32_t apart = (e.number + e.of - f.number) % e.of;
  return e.ring == f.ring && (apart == 1 || apart == e.of - 1);
}

// Returns false where the ring stays at a place or goes back over itself at a corner.
bool add_edges(std::span<const Point2> ring, std::size_t number, std::vector<RingEdge>& edges) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % n];
    if (a == b || doubles_back(ring[(i + n - 1) % n], a, b)) return false;
    edges.push_back({std::min(a, b), std::max(a, b), i, n, number});
  }
  return true;
}

bool none_meet(std::vector<RingEdge> edges) {
  std::sort(edges.begin(), edges.end(), [](const RingEdge& e, const RingEdge& f) { return e.a < f.a; });
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1; k < edges.size() && edges[k].a.x <= edges[i].b.x; ++k)
      if (!are_neighbours(edges[i], edges[k]) && edges_meet(edges[i], edges[k])) return false;
  return true;
}

}  // namespace

bool is_simple_ring(std::span<const Point2> ring) {
  std::vector<RingEdge> edges;
  return ring.size() >= 3 && doubled_area(ring) != 0 && add_edges(ring, 0, edges) && none_meet(std::move(edges));
}

bool is_simple_polygon(std::span<const std::vector<Point2>> rings) {
  std::vector<RingEdge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const __int128 area = rings[r].size() < 3 ? 0 : doubled_area(rings[r]);
    if (area == 0 || (area > 0) != (r == 0) || !add_edges(rings[r], r, edges)) return false;
  }
  if (rings.empty() || !none_meet(std::move(edges))) return false;
  for (std::size_t r = 1; r < rings.size(); ++r)
    for (std::size_t other = 0; other < rings.size(); ++other)
      if (other != r && contains(rings[other], rings[r][0]) != (other == 0)) return false;
  return true;
}

}  // namespace ilot
