// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/constrained.h"

#include <algorithm>
#include <deque>

#include "kernels/delaunay/topology.h"

namespace ilot {
namespace {

class Inserter {
 public:
  Inserter(Triangulation& t, std::span<const Point2> points)
      : t_(t), points_(points), fixed_(t.corner.size()), leaving_(points.size(), kNoEdge) {
    for (std::uint32_t e = 0; e < t.corner.size(); ++e) leaving_[t.corner[e]] = e;
  }

  // Returns false when the segment crosses a fixed edge. The triangulation then stays as it is.
  bool insert(std::uint32_t from, std::uint32_t to) {
    std::vector<VertexPair> pieces;
    for (std::uint32_t at = from; at != to;) {
      const std::uint32_t next = next_corner_on(at, to);
      if (next == kNoEdge) return false;
      pieces.emplace_back(at, next);
      at = next;
    }
    for (const auto& [a, b] : pieces) insert_piece(a, b);
    return true;
  }

  std::vector<std::uint8_t> take_fixed() { return std::move(fixed_); }

 private:
  Point2 at(std::uint32_t v) const { return points_[v]; }
  std::uint32_t target(std::uint32_t e) const { return t_.corner[next_edge(e)]; }
  std::uint32_t apex(std::uint32_t e) const { return t_.corner[previous_edge(e)]; }

  // Calls use(e) for the edges that leave v, once each, until it returns true.
  template <class Use>
  void around(std::uint32_t v, const Use& use) const {
    const std::uint32_t start = leaving_[v];
    std::uint32_t e = start;
    do {
      if (use(e)) return;
      e = t_.twin[previous_edge(e)];
    } while (e != kNoEdge && e != start);
    if (e == start) return;
    for (e = t_.twin[start]; e != kNoEdge; e = t_.twin[e]) {
      e = next_edge(e);
      if (use(e)) return;
    }
  }

  std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) const {
    std::uint32_t found = kNoEdge;
    around(a, [&](std::uint32_t e) {
      if (target(e) == b) found = e;
      if (apex(e) == b && t_.twin[previous_edge(e)] == kNoEdge) found = previous_edge(e);
      return found != kNoEdge;
    });
    return found;
  }

  bool ahead(std::uint32_t a, std::uint32_t b, std::uint32_t v) const {
    const Point2 p = at(a), q = at(b), r = at(v);
    return orient2d(p, q, r) == 0 &&
           static_cast<std::int64_t>(q.x - p.x) * (r.x - p.x) + static_cast<std::int64_t>(q.y - p.y) * (r.y - p.y) > 0;
  }

  // Returns the first corner on the way from a to b, which is b itself at the latest. Returns kNoEdge when a fixed edge
  // is in the way. `crossed` receives the edges in between, as pairs, with the end on the right of the way first.
  std::uint32_t next_corner_on(std::uint32_t a, std::uint32_t b, std::deque<VertexPair>* crossed = nullptr) const {
    std::uint32_t found = kNoEdge, gate = kNoEdge;
    around(a, [&](std::uint32_t e) {
      for (const std::uint32_t v : {target(e), apex(e)})
        if (v == b || ahead(a, b, v)) found = v;
      if (orient2d(at(a), at(b), at(target(e))) < 0 && orient2d(at(a), at(b), at(apex(e))) > 0) gate = next_edge(e);
      return found != kNoEdge || gate != kNoEdge;
    });
    while (found == kNoEdge) {
      if (fixed_[gate]) return kNoEdge;
      if (crossed) crossed->emplace_back(t_.corner[gate], target(gate));
      const std::uint32_t other = t_.twin[gate], v = apex(other);
      const std::int64_t side = orient2d(at(a), at(b), at(v));
      if (side == 0) found = v;
      gate = side > 0 ? next_edge(other) : previous_edge(other);
    }
    return found;
  }

  void insert_piece(std::uint32_t a, std::uint32_t b) {
    std::deque<VertexPair> crossed;
    next_corner_on(a, b, &crossed);
    std::vector<VertexPair> fresh;
    while (!crossed.empty()) {
      const auto [u, v] = crossed.front();
      crossed.pop_front();
      const std::uint32_t e = edge_between(u, v);
      if (!can_flip(e)) {
        crossed.emplace_back(u, v);
        continue;
      }
      const std::uint32_t p = apex(e), q = apex(t_.twin[e]);
      flip(e);
      const std::int64_t side_p = orient2d(at(a), at(b), at(p)), side_q = orient2d(at(a), at(b), at(q));
      const bool crosses = (side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0);
      (crosses ? crossed.emplace_back(p, q) : fresh.emplace_back(p, q));
    }
    const std::uint32_t e = edge_between(a, b);
    fixed_[e] = 1;
    if (t_.twin[e] != kNoEdge) fixed_[t_.twin[e]] = 1;
    restore(std::move(fresh));
  }

  // Whether the two triangles of e form a quadrangle without a straight or reflex corner.
  bool can_flip(std::uint32_t e) const {
    const Point2 a = at(t_.corner[e]), b = at(target(e)), p = at(apex(e)), q = at(apex(t_.twin[e]));
    return orient2d(q, b, p) > 0 && orient2d(p, a, q) > 0;
  }

  // Replaces edge a-b between the triangles with apexes p and q by p-q. Edges e and its twin become a-q and b-p, and
  // the edges after them become q-p and p-q.
  void flip(std::uint32_t e) {
    const std::uint32_t f = t_.twin[e], e1 = next_edge(e), f1 = next_edge(f);
    const std::uint32_t p = apex(e), q = apex(f);
    t_.corner[e1] = q;
    t_.corner[f1] = p;
    attach(e, f1);
    attach(f, e1);
    t_.twin[e1] = f1;
    t_.twin[f1] = e1;
    fixed_[e1] = fixed_[f1] = 0;
    leaving_[t_.corner[e]] = e;
    leaving_[t_.corner[f]] = f;
  }
  // Gives edge e the neighbour of `from`.
  void attach(std::uint32_t e, std::uint32_t from) {
    const std::uint32_t neighbour = t_.twin[from];
    t_.twin[e] = neighbour;
    fixed_[e] = fixed_[from];
    if (neighbour != kNoEdge) t_.twin[neighbour] = e;
  }

  // Flips edges, and the edges around flipped ones, until none has a point in its circle.
  void restore(std::vector<VertexPair> edges) {
    while (!edges.empty()) {
      const std::uint32_t e = edge_between(edges.back().first, edges.back().second);
      edges.pop_back();
      if (e == kNoEdge || fixed_[e] || t_.twin[e] == kNoEdge) continue;
      const std::uint32_t a = t_.corner[e], b = target(e), p = apex(e), q = apex(t_.twin[e]);
      if (!in_circle(at(a), at(b), at(p), at(q))) continue;
      flip(e);
      for (const VertexPair& s : {VertexPair{a, q}, VertexPair{q, b}, VertexPair{b, p}, VertexPair{p, a}})
        edges.push_back(s);
    }
  }

  Triangulation& t_;
  std::span<const Point2> points_;
  std::vector<std::uint8_t> fixed_;
  std::vector<std::uint32_t> leaving_;  // per point one edge that leaves it
};

}  // namespace

Constraints insert_segments(Triangulation& t, std::span<const Point2> points, std::span<const VertexPair> segments) {
  Constraints result;
  Inserter inserter(t, points);
  for (std::uint32_t i = 0; i < segments.size() && result.crossing == kNoEdge; ++i)
    if (!inserter.insert(segments[i].first, segments[i].second)) result.crossing = i;
  result.fixed = inserter.take_fixed();
  return result;
}

std::vector<std::uint8_t> triangles_inside(const Triangulation& t, const Constraints& constraints,
                                           std::span<const VertexPair> segments) {
  std::vector<VertexPair> sides(segments.begin(), segments.end());
  std::sort(sides.begin(), sides.end());
  std::vector<std::uint8_t> inside(t.triangles());
  std::vector<std::uint32_t> stack;
  const auto reach = [&](std::uint32_t triangle) {
    if (inside[triangle]) return;
    inside[triangle] = 1;
    stack.push_back(triangle);
  };
  for (std::uint32_t e = 0; e < t.corner.size(); ++e)
    if (constraints.fixed[e] &&
        std::binary_search(sides.begin(), sides.end(), VertexPair{t.corner[e], t.corner[next_edge(e)]}))
      reach(e / 3);
  while (!stack.empty()) {
    const std::uint32_t triangle = stack.back();
    stack.pop_back();
    for (std::uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
      if (!constraints.fixed[e] && t.twin[e] != kNoEdge) reach(t.twin[e] / 3);
  }
  return inside;
}

}  // namespace ilot
