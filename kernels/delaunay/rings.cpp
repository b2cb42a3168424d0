// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/rings.h"

#include <algorithm>
#include <numeric>

#include "kernels/core/union_find.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

// Whether the direction from `at` to p comes before the one to q when turning clockwise from the direction to `from`.
// The direction to `from` itself comes last.
bool clockwise_before(Point2 at, Point2 from, Point2 p, Point2 q) {
  const auto behind = [&](Point2 r) {  // more than half a turn away
    const std::int64_t side = orient2d(at, from, r);
    if (side != 0) return side > 0;
    const std::int64_t dot = static_cast<std::int64_t>(from.x - at.x) * (r.x - at.x) +
                             static_cast<std::int64_t>(from.y - at.y) * (r.y - at.y);
    return dot > 0;
  };
  const bool p_behind = behind(p), q_behind = behind(q);
  if (p_behind != q_behind) return q_behind;
  return orient2d(at, p, q) < 0;
}

// An outer ring, its box, and the middle of its first edge in half units. This point is on no other ring, because edges
// are not shared.
struct Outer {
  std::span<const std::uint32_t> ring;
  Point2 low, high;
  std::int64_t middle[2];
};

Outer outer_of(const Polygons& polygons, const Ring& r, std::span<const Point2> points) {
  const auto ring = std::span(polygons.vertices).subspan(r.first, r.count);
  const Point2 a = points[ring[0]], b = points[ring[1]];
  Outer outer{ring, a, a, {std::int64_t{a.x} + b.x, std::int64_t{a.y} + b.y}};
  for (const std::uint32_t v : ring) {
    outer.low = {std::min(outer.low.x, points[v].x), std::min(outer.low.y, points[v].y)};
    outer.high = {std::max(outer.high.x, points[v].x), std::max(outer.high.y, points[v].y)};
  }
  return outer;
}

bool box_contains(const Outer& a, const Outer& b) {
  return a.low.x <= b.low.x && b.high.x <= a.high.x && a.low.y <= b.low.y && b.high.y <= a.high.y;
}

// Whether a place in half units, not on the ring, is inside. The function counts the edges that a ray to the right
// crosses.
bool contains(const Outer& outer, const std::int64_t (&place)[2], std::span<const Point2> points) {
  bool inside = false;
  for (std::size_t i = 0, before = outer.ring.size() - 1; i < outer.ring.size(); before = i++) {
    const Point2 a = points[outer.ring[before]], b = points[outer.ring[i]];
    if ((2 * std::int64_t{a.y} > place[1]) == (2 * std::int64_t{b.y} > place[1])) continue;
    const std::int64_t side = (2 * std::int64_t{b.x} - 2 * std::int64_t{a.x}) * (place[1] - 2 * std::int64_t{a.y}) -
                              (2 * std::int64_t{b.y} - 2 * std::int64_t{a.y}) * (place[0] - 2 * std::int64_t{a.x});
    inside ^= b.y > a.y ? side < 0 : side > 0;
  }
  return inside;
}

struct Loop {
  std::vector<std::uint32_t> vertices;
  std::uint32_t region;
  bool hole;
};

class Tracer {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

 public:
  Tracer(std::span<const BoundaryEdge> edges, std::span<const Point2> points)
      : points_(points), edges_(edges), used_(edges.size()), place_(points.size(), kNoEdge) {
    if (std::is_sorted(edges.begin(), edges.end(), before)) return;  // already sorted: no copy
    sorted_.assign(edges.begin(), edges.end());
    std::sort(sorted_.begin(), sorted_.end(), before);
    edges_ = sorted_;
  }

  std::vector<Loop> trace() {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (!used_[i]) follow(i);
    return std::move(loops_);
  }

 private:
  static bool before(const BoundaryEdge& a, const BoundaryEdge& b) {
    if (a.region != b.region) return a.region < b.region;
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  }

  // Returns the unused edge that continues along the fan of triangles on the left of edge i. `start` may be returned
  // again. Returns kNone when the edges do not close.
  std::size_t successor(std::size_t i, std::size_t start) const {
    const BoundaryEdge& in = edges_[i];
    std::size_t best = kNone;
    for (auto k = static_cast<std::size_t>(
             std::lower_bound(edges_.begin(), edges_.end(), BoundaryEdge{in.to, 0, in.region}, before) -
             edges_.begin());
         k < edges_.size() && edges_[k].region == in.region && edges_[k].from == in.to; ++k) {
      if (used_[k] && k != start) continue;
      if (best == kNone ||
          clockwise_before(points_[in.to], points_[in.from], points_[edges_[k].to], points_[edges_[best].to]))
        best = k;
    }
    return best;
  }

  // Walks until the first edge is reached again, and cuts off a loop whenever a vertex is reached again.
  void follow(std::size_t start) {
    const std::uint32_t region = edges_[start].region;
    std::vector<std::uint32_t> path;
    std::size_t i = start;
    do {
      used_[i] = 1;
      place_[edges_[i].from] = static_cast<std::uint32_t>(path.size());
      path.push_back(edges_[i].from);
      if (const std::uint32_t seen = place_[edges_[i].to]; seen != kNoEdge) {
        for (std::size_t k = seen; k < path.size(); ++k) place_[path[k]] = kNoEdge;
        add_loop({path.begin() + seen, path.end()}, region);
        path.resize(seen);
      }
      i = successor(i, start);
    } while (i != start && i != kNone);
    for (const std::uint32_t v : path) place_[v] = kNoEdge;
  }

  void add_loop(std::vector<std::uint32_t> vertices, std::uint32_t region) {
    const auto smallest = std::min_element(vertices.begin(), vertices.end(),
                                           [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; });
    std::rotate(vertices.begin(), smallest, vertices.end());
    // At its smallest vertex the ring turns in the sense in which it runs.
    const bool hole = orient2d(points_[vertices.back()], points_[vertices[0]], points_[vertices[1]]) < 0;
    loops_.push_back({std::move(vertices), region, hole});
  }

  std::span<const Point2> points_;
  std::span<const BoundaryEdge> edges_;  // by region, start and end
  std::vector<BoundaryEdge> sorted_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> place_;  // of a vertex in the path that is being walked
  std::vector<Loop> loops_;
};

}  // namespace

std::vector<BoundaryEdge> boundary_edges(const Triangulation& t, std::span<const std::uint8_t> label) {
  std::vector<std::uint32_t> parent(t.triangles());
  UnionFind regions(parent);
  const auto joined = [&](std::uint32_t e) { return t.twin[e] != kNoEdge && label[e / 3] == label[t.twin[e] / 3]; };
  for (std::uint32_t e = 0; e < t.corner.size(); ++e)
    if (label[e / 3] != 0 && joined(e) && t.twin[e] < e) regions.unite(e / 3, t.twin[e] / 3);
  std::vector<BoundaryEdge> edges;
  for (std::uint32_t e = 0; e < t.corner.size(); ++e)
    if (label[e / 3] != 0 && !joined(e)) edges.push_back({t.corner[e], t.corner[next_edge(e)], regions.find(e / 3)});
  return edges;
}

std::vector<BoundaryEdge> boundary_edges(std::span<const std::uint32_t> corner) {
  const auto target = [&](std::uint32_t e) { return corner[next_edge(e)]; };
  std::vector<std::uint32_t> order(corner.size());
  std::iota(order.begin(), order.end(), 0u);
  // The sort brings the two sides of an edge together.
  const auto key = [&](std::uint32_t e) {
    return std::pair(std::min(corner[e], target(e)), std::max(corner[e], target(e)));
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> parent(corner.size() / 3), alone;
  UnionFind regions(parent);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + 1 < order.size() && key(order[i]) == key(order[i + 1])) {
      regions.unite(order[i] / 3, order[i + 1] / 3);
      ++i;
    } else {
      alone.push_back(order[i]);
    }
  }
  std::vector<BoundaryEdge> edges;
  for (const std::uint32_t e : alone) edges.push_back({corner[e], target(e), regions.find(e / 3)});
  return edges;
}

Polygons assemble_rings(std::span<const BoundaryEdge> edges, std::span<const Point2> points) {
  std::vector<Loop> loops = Tracer(edges, points).trace();
  // Regions are in the order of their outer rings. They are numbered in this order and then sorted.
  std::sort(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) {
    if (a.region != b.region) return a.region < b.region;
    if (a.hole != b.hole) return b.hole;
    return std::lexicographical_compare(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                                        [&](std::uint32_t v, std::uint32_t w) { return points[v] < points[w]; });
  });
  std::vector<std::size_t> polygon;  // its outer ring among the loops
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (!loops[i].hole) polygon.push_back(i);
  std::sort(polygon.begin(), polygon.end(), [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(loops[a].vertices.begin(), loops[a].vertices.end(), loops[b].vertices.begin(),
                                        loops[b].vertices.end(),
                                        [&](std::uint32_t v, std::uint32_t w) { return points[v] < points[w]; });
  });
  Polygons out;
  std::size_t vertices = 0;
  for (const Loop& loop : loops) vertices += loop.vertices.size();
  out.vertices.reserve(vertices);
  for (const std::size_t outer : polygon) {
    for (std::size_t i = outer; i < loops.size() && loops[i].region == loops[outer].region; ++i) {
      const auto& v = loops[i].vertices;
      out.rings.push_back(
          {static_cast<std::uint32_t>(out.vertices.size()), static_cast<std::uint32_t>(v.size()), out.count});
      out.vertices.insert(out.vertices.end(), v.begin(), v.end());
    }
    ++out.count;
  }
  return out;
}

Polygons outer_rings(const Polygons& polygons, std::span<const Point2> points) {
  std::vector<Outer> outers;
  for (std::size_t i = 0; i < polygons.rings.size(); ++i)
    if (i == 0 || polygons.rings[i].polygon != polygons.rings[i - 1].polygon)
      outers.push_back(outer_of(polygons, polygons.rings[i], points));
  Polygons out;
  for (std::size_t i = 0; i < outers.size(); ++i) {
    const bool inside = std::any_of(outers.begin(), outers.end(), [&](const Outer& other) {
      return &other != &outers[i] && box_contains(other, outers[i]) && contains(other, outers[i].middle, points);
    });
    if (inside) continue;
    out.rings.push_back({static_cast<std::uint32_t>(out.vertices.size()),
                         static_cast<std::uint32_t>(outers[i].ring.size()), out.count});
    out.vertices.insert(out.vertices.end(), outers[i].ring.begin(), outers[i].ring.end());
    ++out.count;
  }
  return out;
}

std::int64_t twice_area(const Polygons& polygons, const Ring& ring, std::span<const Point2> points) {
  const auto corner = [&](std::size_t i) { return points[polygons.vertices[ring.first + i]]; };
  return doubled_area<std::int64_t>(ring.count, corner);
}

}  // namespace ilot
