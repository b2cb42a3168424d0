// SPDX-License-Identifier: Apache-2.0
#include "study/document_roofs/roof_graph.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ilot::bench {

namespace {

// Follows the edges of the border from each unused edge until there is no next one. Returns the longest such chain.
std::vector<std::uint32_t> longest_chain(const Mesh& m) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> leaving;
  std::vector<std::uint32_t> border, best;
  for (std::uint32_t e = 0; e < m.t.corner.size(); ++e)
    if (m.on_border(e)) {
      border.push_back(e);
      leaving[m.t.corner[e]].push_back(e);
    }
  std::vector<std::uint8_t> used(m.t.corner.size());
  for (const std::uint32_t first : border) {
    std::vector<std::uint32_t> chain;
    for (std::uint32_t e = first; e != kNoEdge && used[e] == 0;) {
      used[e] = 1;
      chain.push_back(e);
      const auto& ways = leaving[m.t.corner[next_edge(e)]];
      const auto way = std::find_if(ways.begin(), ways.end(), [&](std::uint32_t w) { return used[w] == 0; });
      e = way == ways.end() ? kNoEdge : *way;
    }
    if (chain.size() > best.size()) best = std::move(chain);
  }
  return best;
}

// Returns the points of the border, with a junction in the middle of each edge between two labels.
std::vector<Corner> contour_of(const Mesh& m, const LabelledRoof& b, const std::vector<std::uint32_t>& chain) {
  std::vector<Corner> contour;
  for (const std::uint32_t e : chain) {
    const std::uint32_t p = m.t.corner[e], q = m.t.corner[next_edge(e)];
    contour.push_back({b.points[p], {b.label[p]}, b.label[p], kNoEdge});
    if (b.label[p] != b.label[q])
      contour.push_back({0.5 * (b.points[p] + b.points[q]), {b.label[p], b.label[q]}, b.label[q], e});
  }
  return contour;
}

Corner& around(std::vector<Corner>& ring, std::size_t i, std::size_t by) {
  return ring[(i + by) % ring.size()];
}

// Returns the cosine of the angle at b in plan, or 1 where b coincides with a or c.
double cosine_at(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 u = a - b, v = c - b;
  const double lengths = std::sqrt(plan_dot(u, u) * plan_dot(v, v));
  return lengths > 0 ? plan_dot(u, v) / lengths : 1;
}

// Algorithm 1 of the document.
void smooth(std::vector<Corner>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Corner& p = ring[i];
    const Corner &before = around(ring, i, ring.size() - 1), &next = around(ring, i, 1);
    if (p.junction() || !before.has(p.labels[0]) || !next.has(p.labels[0])) continue;
    const Vec3 along = next.at - before.at;
    if (std::abs(cosine_at(before.at, p.at, next.at)) >= 0.8 || dot(along, along) == 0) continue;
    p.at = before.at + (dot(p.at - before.at, along) / dot(along, along)) * along;
  }
}

double cost_of(const Corner& a, const Corner& b, const Corner& c) {
  constexpr double kCosine = 0.70710678118654752;  // cosine of 45 degrees; that of 135 degrees is its negative
  if (b.junction() || std::abs(cosine_at(a.at, b.at, c.at)) <= kCosine) return std::numeric_limits<double>::infinity();
  const Vec3 u = b.at - a.at, v = c.at - a.at;
  return std::abs(u.x * v.y - u.y * v.x) / 2;
}

// Algorithm 2: while some corner is flatter than 135 or sharper than 45 degrees, the one with the smallest triangle is
// removed.
void drop_flat(std::vector<Corner>& ring) {
  while (ring.size() > 3) {
    std::size_t least = 0;
    double cost = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double c = cost_of(around(ring, i, ring.size() - 1), ring[i], around(ring, i, 1));
      if (c < cost) {
        cost = c;
        least = i;
      }
    }
    if (std::isinf(cost)) return;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

// Algorithm 3: keeps one corner within the radius. A corner where planes meet is never removed.
void thin(std::vector<Corner>& ring, double radius) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    std::size_t gone = ring.size();
    for (const std::size_t by : {ring.size() - 1, std::size_t{1}}) {
      const std::size_t other = (i + by) % ring.size();
      const Vec3 d = ring[other].at - ring[i].at;
      if (gone != ring.size() || plan_dot(d, d) >= radius * radius) continue;
      gone = !ring[i].junction() ? i : !ring[other].junction() ? other : ring.size();
    }
    if (gone == ring.size())
      ++i;
    else
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(gone));
  }
}

// Lines between faces. They run from each junction, and from each end, over the triangles with two labels to the next
// one.
struct InnerLines {
  const Mesh& m;
  const LabelledRoof& b;
  std::map<std::uint32_t, std::uint32_t> of_border_edge, of_triangle;  // corners of the graph

  bool mixed(std::uint32_t e) const { return b.label[m.t.corner[e]] != b.label[m.t.corner[next_edge(e)]]; }
  bool leads_on(std::uint32_t e) const { return mixed(e) && (m.kept(m.t.twin[e]) || of_border_edge.count(e) != 0); }
  int ways(std::uint32_t triangle) const {
    return leads_on(3 * triangle) + leads_on(3 * triangle + 1) + leads_on(3 * triangle + 2);
  }
  // Returns the corner at which the line that leaves a triangle over edge e ends. Stores its last edge in `e`.
  std::uint32_t end_of(std::uint32_t& e) const {
    for (;;) {
      if (!m.kept(m.t.twin[e])) return of_border_edge.at(e);
      const std::uint32_t in = m.t.twin[e];
      const auto corner = of_triangle.find(in / 3);
      if (corner != of_triangle.end()) {
        e = in;
        return corner->second;
      }
      e = leads_on(next_edge(in)) ? next_edge(in) : previous_edge(in);
    }
  }
};

void add_inner(const Mesh& m, const LabelledRoof& b, Graph& g) {
  InnerLines lines{m, b, {}, {}};
  for (std::uint32_t i = 0; i < g.corners.size(); ++i)
    if (g.corners[i].border_edge != kNoEdge) lines.of_border_edge[g.corners[i].border_edge] = i;
  for (std::uint32_t t = 0; t < m.keep.size(); ++t) {
    const std::uint32_t c[3]{m.t.corner[3 * t], m.t.corner[3 * t + 1], m.t.corner[3 * t + 2]};
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t p : c)
      if (std::find(labels.begin(), labels.end(), b.label[p]) == labels.end()) labels.push_back(b.label[p]);
    if (m.keep[t] == 0 || labels.size() < 2 || (labels.size() == 2 && lines.ways(t) == 2)) continue;
    lines.of_triangle[t] = static_cast<std::uint32_t>(g.corners.size());
    g.corners.push_back({(1.0 / 3) * (b.points[c[0]] + b.points[c[1]] + b.points[c[2]]), labels, 0, kNoEdge});
  }
  g.links.resize(g.corners.size());
  std::vector<std::uint8_t> done(m.t.corner.size());
  const auto follow = [&](std::uint32_t from, std::uint32_t e) {
    const std::uint32_t left = b.label[m.t.corner[e]], right = b.label[m.t.corner[next_edge(e)]];
    done[e] = 1;
    const std::uint32_t to = lines.end_of(e);
    done[e] = 1;
    if (to != from) g.join(from, to, left, right);
  };
  for (const auto& [triangle, corner] : lines.of_triangle)
    for (std::uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
      if (lines.leads_on(e) && done[e] == 0) follow(corner, e);
  // The remaining lines run from border to border.
  for (const auto& [edge, corner] : lines.of_border_edge) {
    if (done[edge] != 0 || lines.of_triangle.count(edge / 3) != 0) continue;
    done[edge] = 1;
    follow(corner, lines.leads_on(next_edge(edge)) ? next_edge(edge) : previous_edge(edge));
  }
}

}  // namespace

Mesh eroded(const std::vector<Vec3>& points, double alpha, Distance distance) {
  std::vector<Point2> places;
  for (const Vec3& p : points) places.push_back(place_of(p));
  Mesh m{delaunay(places), {}};
  m.keep.assign(m.t.triangles(), 1);
  std::vector<std::uint32_t> open;
  for (std::uint32_t e = 0; e < m.t.corner.size(); ++e)
    if (m.t.twin[e] == kNoEdge) open.push_back(e);
  while (!open.empty()) {
    const std::uint32_t e = open.back();
    open.pop_back();
    if (!m.kept(e)) continue;
    Vec3 d = points[m.t.corner[next_edge(e)]] - points[m.t.corner[e]];
    if (distance == Distance::kPlan) d.z = 0;
    if (norm(d) <= alpha) continue;
    m.keep[e / 3] = 0;
    for (const std::uint32_t other : {next_edge(e), previous_edge(e)})
      if (m.kept(m.t.twin[other])) open.push_back(m.t.twin[other]);
  }
  return m;
}

Graph graph_of(const Mesh& m, const LabelledRoof& b, double radius) {
  Graph g;
  g.corners = contour_of(m, b, longest_chain(m));
  if (g.corners.size() < 3) return {};
  smooth(g.corners);
  drop_flat(g.corners);
  thin(g.corners, radius);
  g.links.resize(g.corners.size());
  const auto n = static_cast<std::uint32_t>(g.corners.size());
  for (std::uint32_t i = 0; i < n; ++i) g.join(i, (i + 1) % n, g.corners[i].after, g.corners[i].after);
  add_inner(m, b, g);
  return g;
}

}  // namespace ilot::bench
