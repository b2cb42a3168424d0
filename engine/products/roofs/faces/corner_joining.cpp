// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/corner_joining.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

// Derived: planes that differ in slope by less cannot place a corner.
constexpr double kLeastSlope = 0.05;

enum class Place : std::uint8_t { inside, on_outline, corner };

class CornerJoiner {
 public:
  CornerJoiner(Partition& p, const SitePolygon& outline, std::span<const RoofPlane> planes, double reach)
      : p_(p), planes_(planes), reach_(reach), parents_(p.vertices.size()), sets_(parents_) {
    const std::vector<std::uint8_t> corners = corners_in(p, outline);
    place_.assign(p.vertices.size(), Place::inside);
    for (const PartitionEdge& e : p.edges)
      if (on_outline(e)) place_[e.from] = place_[e.to] = Place::on_outline;
    edges_of_.resize(p.vertices.size());
    for (std::uint32_t i = 0; i < p.edges.size(); ++i) {
      edges_of_[p.edges[i].from].push_back(i);
      edges_of_[p.edges[i].to].push_back(i);
    }
    for (std::size_t v = 0; v < corners.size(); ++v)
      if (corners[v] != 0) place_[v] = Place::corner;
  }

  void run() {
    std::set<std::pair<std::int64_t, std::uint32_t>> open;  // squared length and edge
    const auto limit = static_cast<std::int64_t>(reach_ * reach_ * 1e6);
    const auto length2 = [&](std::uint32_t i) { return squared_distance(at(p_.edges[i].from), at(p_.edges[i].to)); };
    for (std::uint32_t i = 0; i < p_.edges.size(); ++i)
      if (length2(i) < limit) open.insert({length2(i), i});
    while (!open.empty()) {
      const auto [length, edge] = *open.begin();
      open.erase(open.begin());
      if (length2(edge) != length && length2(edge) < limit) {  // an end has moved since
        open.insert({length2(edge), edge});
        continue;
      }
      if (length2(edge) < limit) join(edge);
    }
    for (std::uint32_t v = 0; v < p_.vertices.size(); ++v) moved_.push_back(at(v));
    p_.vertices = std::move(moved_);
    tidy(p_);
  }

 private:
  static bool on_outline(const PartitionEdge& e) { return e.left == kOutside || e.right == kOutside; }
  Point2 at(std::uint32_t v) { return p_.vertices[sets_.find(v)]; }

  void join(std::uint32_t edge) {
    const std::uint32_t a = sets_.find(p_.edges[edge].from), b = sets_.find(p_.edges[edge].to);
    if (a == b) return;
    const Place most = std::max(place_[a], place_[b]), least = std::min(place_[a], place_[b]);
    if (least == Place::corner) return;
    if (least == Place::on_outline && !on_outline(p_.edges[edge])) return;
    const Point2 to = most == Place::inside ? meeting(a, b) : p_.vertices[place_[a] == most ? a : b];
    if (crosses(a, b, to)) return;
    sets_.unite(a, b);
    const std::uint32_t root = sets_.find(a), other = root == a ? b : a;
    p_.vertices[root] = to;
    place_[root] = most;
    edges_of_[root].insert(edges_of_[root].end(), edges_of_[other].begin(), edges_of_[other].end());
    edges_of_[other].clear();
  }

  // The place near the middle of two vertices where the heights of the faces around them agree best.
  Point2 meeting(std::uint32_t a, std::uint32_t b) const {
    const Point2 p = p_.vertices[a], q = p_.vertices[b];
    const double mx = (p.x + q.x) / 2000.0, my = (p.y + q.y) / 2000.0;
    std::set<std::uint32_t> around;
    for (const std::uint32_t v : {a, b})
      for (const std::uint32_t e : edges_of_[v]) around.insert({p_.edges[e].left, p_.edges[e].right});
    around.erase(kOutside);
    double gx = 0, gy = 0, z = 0;
    for (const std::uint32_t f : around) {
      gx += planes_[f - 1].gx / static_cast<double>(around.size());
      gy += planes_[f - 1].gy / static_cast<double>(around.size());
      z += planes_[f - 1].at(mx, my) / static_cast<double>(around.size());
    }
    double xx = kLeastSlope * kLeastSlope, xy = 0, yy = xx, x = 0, y = 0;
    for (const std::uint32_t f : around) {
      const double dx = planes_[f - 1].gx - gx, dy = planes_[f - 1].gy - gy, dz = planes_[f - 1].at(mx, my) - z;
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
      x -= dx * dz;
      y -= dy * dz;
    }
    const double det = xx * yy - xy * xy;
    double sx = (x * yy - y * xy) / det, sy = (y * xx - x * xy) / det;
    const double far = std::sqrt(sx * sx + sy * sy);
    if (!(far <= reach_)) sx = sy = 0;
    return lattice_point({mx + sx, my + sy}, 1000);
  }

  // Returns true when an edge that ends in a or b and now leads to `to` would touch another edge.
  bool crosses(std::uint32_t a, std::uint32_t b, Point2 to) {
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t v : {a, b})
      for (const std::uint32_t i : edges_of_[v])
        for (const std::uint32_t u : {sets_.find(p_.edges[i].from), sets_.find(p_.edges[i].to)})
          if (u != a && u != b) ends.push_back(u);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (const PartitionEdge& e : p_.edges) {
      const std::uint32_t u = sets_.find(e.from), v = sets_.find(e.to);
      if (u == v || u == a || u == b || v == a || v == b) continue;
      for (const std::uint32_t end : ends)
        if (touches(to, end, u, v)) return true;
    }
    return std::any_of(ends.begin(), ends.end(), [&](std::uint32_t end) { return p_.vertices[end] == to; });
  }

  // Returns true when the segment from `to` to the vertex `end` meets the edge u, v beyond a common end.
  bool touches(Point2 to, std::uint32_t end, std::uint32_t u, std::uint32_t v) const {
    const Point2 e = p_.vertices[end], p = p_.vertices[u], q = p_.vertices[v];
    if (std::max(p.x, q.x) < std::min(to.x, e.x) || std::min(p.x, q.x) > std::max(to.x, e.x)) return false;
    if (std::max(p.y, q.y) < std::min(to.y, e.y) || std::min(p.y, q.y) > std::max(to.y, e.y)) return false;
    const auto side = [](Point2 o, Point2 d, Point2 r) {
      const auto turn = orient2d(o, d, r);
      return turn > 0 ? 1 : turn < 0 ? -1 : 0;
    };
    if (end == u || end == v) {
      const Point2 other = end == u ? q : p;
      if (side(to, e, other) != 0) return false;
      const double along =
          static_cast<double>(to.x - e.x) * (other.x - e.x) + static_cast<double>(to.y - e.y) * (other.y - e.y);
      return along > 0;
    }
    return side(to, e, p) * side(to, e, q) <= 0 && side(p, q, to) * side(p, q, e) <= 0;
  }

  Partition& p_;
  std::span<const RoofPlane> planes_;
  double reach_;
  std::vector<std::uint32_t> parents_;
  UnionFind sets_;
  std::vector<Place> place_;                          // per root
  std::vector<std::vector<std::uint32_t>> edges_of_;  // per root
  std::vector<Point2> moved_;
};

}  // namespace

void join_corners(Partition& faces, const SitePolygon& outline, std::span<const RoofPlane> planes, double reach) {
  CornerJoiner(faces, outline, planes, reach).run();
}

}  // namespace ilot
