// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/simple_ring.h"

#include <algorithm>
#include <vector>

namespace ilot {
namespace {

struct RingEdge {
  Point2 a, b;  // left to right
  std::uint32_t number;
};

int turn(Point2 a, Point2 b, Point2 c) {
  const std::int64_t v = orient2d(a, b, c);
  return v > 0 ? 1 : v < 0 ? -1 : 0;
}

// c lies on the line through a and b, a < b.
bool within(Point2 a, Point2 b, Point2 c) {
  return a <= c && c <= b;
}

bool edges_meet(const RingEdge& e, const RingEdge& f) {
  const int p = turn(e.a, e.b, f.a), q = turn(e.a, e.b, f.b), r = turn(f.a, f.b, e.a), s = turn(f.a, f.b, e.b);
  if (p * q < 0 && r * s < 0) return true;
  return (p == 0 && within(e.a, e.b, f.a)) || (q == 0 && within(e.a, e.b, f.b)) || (r == 0 && within(f.a, f.b, e.a)) ||
         (s == 0 && within(f.a, f.b, e.b));
}

// From `corner` the ring goes back over the edge it came by, or to the same place.
bool doubles_back(Point2 before, Point2 corner, Point2 after) {
  if (orient2d(before, corner, after) != 0) return false;
  return (before < corner) == (after < corner);
}

}  // namespace

__int128 doubled_area(std::span<const Point2> ring) {
  __int128 sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += orient2d(ring[0], ring[i], ring[i + 1]);
  return sum;
}

bool is_simple_ring(std::span<const Point2> ring) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  if (n < 3 || doubled_area(ring) == 0) return false;
  std::vector<RingEdge> edges;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % n];
    if (a == b || doubles_back(ring[(i + n - 1) % n], a, b)) return false;
    edges.push_back({std::min(a, b), std::max(a, b), i});
  }
  std::sort(edges.begin(), edges.end(), [](const RingEdge& e, const RingEdge& f) { return e.a < f.a; });
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = i + 1; k < n && edges[k].a.x <= edges[i].b.x; ++k) {
      const std::uint32_t apart = (edges[k].number + n - edges[i].number) % n;
      if (apart != 1 && apart != n - 1 && edges_meet(edges[i], edges[k])) return false;
    }
  }
  return true;
}

}  // namespace ilot
