// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/partition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/products/roofs/faces/line_net.h"
#include "engine/products/roofs/faces/net_cells.h"
#include "kernels/core/union_find.h"
#include "kernels/delaunay/rings.h"

namespace ilot {
namespace {

// Derived: snap rounding bends straight lines by less than the square root of 2 steps of the grid of 1 mm.
constexpr double kBentByRounding = 1.5;  // millimetres

// Removes vertices in the middle of straight borders between the same two regions. It walks from junction to junction.
class Straightener {
 public:
  // `inner`: millimetres by which borders between two faces may change; the outline stays.
  Straightener(Partition& partition, std::span<const std::uint8_t> fixed, double inner)
      : p_(partition), fixed_(fixed), inner_(inner) {}

  void run() {
    around_.resize(p_.vertices.size());
    for (std::uint32_t e = 0; e < p_.edges.size(); ++e) {
      around_[p_.edges[e].from].push_back(e);
      around_[p_.edges[e].to].push_back(e);
    }
    done_.assign(p_.edges.size(), 0);
    for (std::uint32_t v = 0; v < p_.vertices.size(); ++v)
      if (ends(v))
        for (const std::uint32_t e : around_[v]) walk(v, e);
    for (std::uint32_t e = 0; e < p_.edges.size(); ++e)  // closed borders without a junction
      if (!done_[e]) walk(p_.edges[e].from, e);
    p_.edges = std::move(edges_);
  }

 private:
  bool ends(std::uint32_t v) const { return around_[v].size() != 2 || fixed_[v] != 0; }

  void walk(std::uint32_t start, std::uint32_t e) {
    if (done_[e]) return;
    std::vector<std::uint32_t> chain{start};
    const PartitionEdge first = p_.edges[e];
    const std::uint32_t left = first.from == start ? first.left : first.right;
    const std::uint32_t right = first.from == start ? first.right : first.left;
    for (;;) {
      done_[e] = 1;
      const PartitionEdge& edge = p_.edges[e];
      const std::uint32_t next = edge.from == chain.back() ? edge.to : edge.from;
      chain.push_back(next);
      if (next == start || ends(next)) break;
      e = around_[next][0] == e ? around_[next][1] : around_[next][0];
    }
    const std::size_t last = chain.size() - 1;
    if (chain.front() != chain.back()) {
      straighten(chain, 0, last, left, right);
    } else {  // a closed border: it starts at the far side, so that it does not collapse to a line
      const auto far =
          static_cast<std::size_t>(std::max_element(chain.begin(), chain.end(),
                                                    [&](std::uint32_t a, std::uint32_t b) {
                                                      return squared_distance(p_.vertices[a], p_.vertices[start]) <
                                                             squared_distance(p_.vertices[b], p_.vertices[start]);
                                                    }) -
                                   chain.begin());
      straighten(chain, 0, far, left, right);
      straighten(chain, far, last, left, right);
    }
  }

  // Simplifies by Douglas and Peucker.
  void straighten(const std::vector<std::uint32_t>& chain, std::size_t from, std::size_t to, std::uint32_t left,
                  std::uint32_t right) {
    const double tolerance = left == kOutside || right == kOutside ? kBentByRounding : inner_;
    const Point2 a = p_.vertices[chain[from]], b = p_.vertices[chain[to]];
    const double length = std::sqrt(static_cast<double>(squared_distance(a, b)));
    double worst = 0;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = std::abs(static_cast<double>(orient2d(a, b, p_.vertices[chain[i]]))) / std::max(length, 1.0);
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    if (worst > tolerance) {
      straighten(chain, from, at, left, right);
      straighten(chain, at, to, left, right);
    } else {
      const std::uint32_t u = chain[from], v = chain[to];
      edges_.push_back(u < v ? PartitionEdge{u, v, left, right} : PartitionEdge{v, u, right, left});
    }
  }

  Partition& p_;
  std::span<const std::uint8_t> fixed_;
  double inner_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::uint8_t> done_;
  std::vector<PartitionEdge> edges_;
};

// The edges of a partition in strips across x, each of which has all edges that cross it.
class EdgeStrips {
 public:
  // Vertices ascend by x.
  explicit EdgeStrips(const Partition& p)
      : strips_(static_cast<std::size_t>(4 * std::sqrt(static_cast<double>(p.edges.size()))) + 1),
        low_(p.vertices.front().x),
        high_(p.vertices.back().x),
        width_((high_ - low_) / static_cast<double>(strips_) + 1),
        first_(strips_ + 1, 0) {
    for (const PartitionEdge& e : p.edges) for_each_strip(p, e, [&](std::size_t s) { ++first_[s]; });
    for (std::uint32_t end = 0; std::uint32_t & f : first_) end = f += end;
    crossings_.resize(first_.back());
    for (auto e = static_cast<std::uint32_t>(p.edges.size()); e-- > 0;)
      for_each_strip(p, p.edges[e], [&](std::size_t s) { crossings_[--first_[s]] = crossing(p, e); });
    for (std::size_t s = 0; s < strips_; ++s)
      std::sort(crossings_.begin() + first_[s], crossings_.begin() + first_[s + 1],
                [](const auto& a, const auto& b) { return a.high != b.high ? a.high > b.high : a.edge < b.edge; });
  }

  // The region above the nearest edge below a point; of edges at one height, the first of the partition counts.
  std::uint32_t region_above_edge_below(FlatPoint p) const {
    if (p.x < low_ || p.x > high_) return kOutside;
    // Derived: far above the rounding of heights.
    constexpr double kRounding = 1;  // millimetres
    double nearest = -INFINITY;
    const Crossing* best = nullptr;
    const std::size_t strip = strip_of(p.x);
    for (std::uint32_t i = first_[strip]; i < first_[strip + 1]; ++i) {
      const Crossing& c = crossings_[i];
      if (c.high + kRounding < nearest) break;
      if ((p.x < c.ax) | (p.x >= c.bx) | (c.low > p.y)) continue;  // without branches, which could not be foreseen
      const double y = c.ay + (p.x - c.ax) / (c.bx - c.ax) * (c.by - c.ay);
      if (y > p.y || y < nearest || (y == nearest && best != nullptr && best->edge < c.edge)) continue;
      nearest = y;
      best = &c;
    }
    return best == nullptr ? kOutside : best->left;
  }

 private:
  struct Crossing {
    double ax, ay, bx, by, low, high;
    std::uint32_t edge, left;
  };

  static Crossing crossing(const Partition& p, std::uint32_t edge) {
    const PartitionEdge& e = p.edges[edge];  // from < to: it runs towards +x, its left is above it
    const Point2 a = p.vertices[e.from], b = p.vertices[e.to];
    const double ay = a.y, by = b.y;
    return {
        static_cast<double>(a.x), ay, static_cast<double>(b.x), by, std::min(ay, by), std::max(ay, by), edge, e.left};
  }
  std::size_t strip_of(double x) const {
    return static_cast<std::size_t>(std::clamp((x - low_) / width_, 0.0, static_cast<double>(strips_ - 1)));
  }
  template <class Visit>
  void for_each_strip(const Partition& p, const PartitionEdge& e, const Visit& visit) const {
    const Point2 a = p.vertices[e.from], b = p.vertices[e.to];
    if (a.x == b.x) return;  // never below
    const std::size_t last = strip_of(b.x);
    for (std::size_t s = strip_of(a.x); s <= last; ++s) visit(s);
  }

  std::size_t strips_;
  double low_, high_, width_;
  std::vector<std::uint32_t> first_;  // per strip, and one more entry
  std::vector<Crossing> crossings_;   // strip by strip, those that reach highest first
};

// Sorts the vertices and keeps one of those at the same place.
void join_vertices(Partition& p) {
  std::vector<Point2> places = p.vertices;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto number = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(places.begin(), places.end(), p.vertices[v]) - places.begin());
  };
  for (PartitionEdge& e : p.edges) {
    e.from = number(e.from);
    e.to = number(e.to);
  }
  p.vertices = std::move(places);
}

// Removes vertices that no edge uses; the others keep their order.
void drop_unused_vertices(Partition& p) {
  std::vector<std::uint32_t> number(p.vertices.size(), 0);
  for (const PartitionEdge& e : p.edges) number[e.from] = number[e.to] = 1;
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < p.vertices.size(); ++v) {
    if (number[v] == 0) continue;
    p.vertices[kept] = p.vertices[v];
    number[v] = kept++;
  }
  p.vertices.resize(kept);
  for (PartitionEdge& e : p.edges) {
    e.from = number[e.from];
    e.to = number[e.to];
  }
}

// Makes inner edges that pass a vertex within reach (metres) go through it.
void pass_through_near_vertices(Partition& p, double reach) {
  const double reach_mm = reach * 1000;
  const auto edges = static_cast<std::uint32_t>(p.edges.size());
  for (std::uint32_t i = 0; i < edges; ++i) {
    const PartitionEdge e = p.edges[i];
    if (e.left == kOutside || e.right == kOutside) continue;
    const Point2 a = p.vertices[e.from], b = p.vertices[e.to];  // a.x <= b.x, as vertices ascend
    const double length2 = static_cast<double>(squared_distance(a, b)), length = std::sqrt(length2);
    std::vector<std::pair<double, std::uint32_t>> passed;
    const auto first = std::lower_bound(p.vertices.begin(), p.vertices.end(), a.x - reach_mm,
                                        [](Point2 v, double x) { return v.x < x; });
    for (auto v = first; v != p.vertices.end() && v->x <= b.x + reach_mm; ++v) {
      const double along =
          static_cast<double>(v->x - a.x) * (b.x - a.x) + static_cast<double>(v->y - a.y) * (b.y - a.y);
      if (along <= 0 || along >= length2 || *v == a || *v == b) continue;
      if (std::abs(static_cast<double>(orient2d(a, b, *v))) > reach_mm * length) continue;
      passed.emplace_back(along, static_cast<std::uint32_t>(v - p.vertices.begin()));
    }
    std::sort(passed.begin(), passed.end());
    std::uint32_t from = e.from;
    for (const auto& [along, v] : passed) {
      p.edges.push_back({from, v, e.left, e.right});
      from = v;
    }
    p.edges[i].from = from;
  }
  tidy(p);
}

Point2 millimetres(FlatPoint metres) {
  const auto rounded = [](double v) {
    // Derived: the range of exact coordinates.
    constexpr double kMost = kMaxPlaneCoordinate;
    return static_cast<std::int32_t>(std::clamp(std::round(v * 1000), -kMost, kMost));
  };
  return {rounded(metres.x), rounded(metres.y)};
}

}  // namespace

bool turns_before(Point2 o, Point2 p, Point2 q) {
  const auto lower = [&](Point2 r) { return r.y < o.y || (r.y == o.y && r.x < o.x); };
  if (lower(p) != lower(q)) return lower(q);
  return orient2d(o, p, q) > 0;
}

void tidy(Partition& p) {
  join_vertices(p);
  for (PartitionEdge& e : p.edges)
    if (e.from > e.to) e = {e.to, e.from, e.right, e.left};
  std::sort(p.edges.begin(), p.edges.end(), [](const PartitionEdge& a, const PartitionEdge& b) {
    return std::tie(a.from, a.to, a.left, a.right) < std::tie(b.from, b.to, b.left, b.right);
  });
  std::vector<PartitionEdge> kept;
  for (const PartitionEdge& e : p.edges) {
    if (e.from == e.to) continue;
    if (kept.empty() || kept.back().from != e.from || kept.back().to != e.to) {
      kept.push_back(e);
    } else if (kept.back().right == e.left) {
      kept.back().right = e.right;
    } else if (kept.back().left == e.right) {
      kept.back().left = e.left;
    } else {              // NOLINT(bugprone-branch-clone): as where nothing is kept, for another reason
      kept.push_back(e);  // regions overlap: this is no planar subdivision, but every region is still closed
    }
    if (kept.back().left == kept.back().right) kept.pop_back();
  }
  p.edges = std::move(kept);
  drop_unused_vertices(p);
}

void close_short_edges(Partition& p, const SitePolygon& outline, double shortest) {
  std::vector<std::uint8_t> fixed = corners_in(p, outline);
  const double least2 = shortest * shortest * 1e6;
  std::vector<std::uint32_t> parents(p.vertices.size());
  UnionFind sets(parents);
  for (const PartitionEdge& e : p.edges) {
    if (static_cast<double>(squared_distance(p.vertices[e.from], p.vertices[e.to])) >= least2) continue;
    const std::uint32_t a = sets.find(e.from), b = sets.find(e.to);
    if (a == b || (fixed[a] && fixed[b])) continue;
    const Point2 at = p.vertices[fixed[b] ? b : a];
    const std::uint8_t stays = fixed[a] | fixed[b];
    sets.unite(a, b);
    p.vertices[sets.find(a)] = at;
    fixed[sets.find(a)] = stays;
  }
  for (std::uint32_t v = 0; v < p.vertices.size(); ++v) p.vertices[v] = p.vertices[sets.find(v)];
  tidy(p);
  pass_through_near_vertices(p, shortest);
}

std::vector<std::uint8_t> corners_in(const Partition& partition, const SitePolygon& outline) {
  std::vector<Point2> corners;
  for (const auto& ring : outline) corners.insert(corners.end(), ring.begin(), ring.end());
  std::sort(corners.begin(), corners.end());
  std::vector<std::uint8_t> flags;
  for (const Point2 v : partition.vertices) flags.push_back(std::binary_search(corners.begin(), corners.end(), v));
  return flags;
}

Partition part(const SitePolygon& outline, std::span<const FlatEdge> lines) {
  std::vector<NetSegment> segments;
  for (const auto& ring : outline)
    for (std::size_t i = 0; i < ring.size(); ++i) segments.push_back({ring[i], ring[(i + 1) % ring.size()], true});
  for (const FlatEdge& line : lines) segments.push_back({millimetres(line.a), millimetres(line.b), false});
  return cells_inside(snap_rounded(segments));
}

std::vector<std::uint32_t> regions_of(const Partition& partition, std::span<const FlatPoint> points) {
  std::vector<std::uint32_t> regions(points.size(), kOutside);
  if (partition.edges.empty()) return regions;
  const EdgeStrips strips(partition);
  std::ranges::transform(points, regions.begin(), [&](FlatPoint p) { return strips.region_above_edge_below(p); });
  return regions;
}

Partition merged(const Partition& partition, std::span<const std::uint32_t> label, std::uint32_t labels,
                 std::span<const std::uint8_t> fixed) {
  Partition m;
  m.vertices = partition.vertices;
  m.regions = labels;
  const auto region = [&](std::uint32_t r) { return r == kOutside ? kOutside : label[r - 1]; };
  for (const PartitionEdge& e : partition.edges) {
    const PartitionEdge kept{e.from, e.to, region(e.left), region(e.right)};
    if (kept.left != kept.right) m.edges.push_back(kept);
  }
  Straightener(m, fixed, kBentByRounding).run();
  tidy(m);
  return m;
}

void straighten_borders(Partition& p, const SitePolygon& outline, double tolerance) {
  const std::vector<std::uint8_t> fixed = corners_in(p, outline);
  Straightener(p, fixed, std::max(kBentByRounding, tolerance * 1000)).run();
  tidy(p);
}

std::vector<SitePolygon> region_polygons(const Partition& partition) {
  std::vector<std::vector<BoundaryEdge>> edges(partition.regions + 1);
  for (const PartitionEdge& e : partition.edges) {
    edges[e.left].push_back({e.from, e.to, e.left});
    edges[e.right].push_back({e.to, e.from, e.right});
  }
  std::vector<SitePolygon> all;
  for (std::uint32_t r = 1; r <= partition.regions; ++r) {
    const Polygons polygons = assemble_rings(edges[r], partition.vertices);
    for (const Ring& ring : polygons.rings) {
      if (&ring == &polygons.rings.front() || ring.polygon != (&ring - 1)->polygon) all.emplace_back();
      auto& corners = all.back().emplace_back();
      for (std::uint32_t i = 0; i < ring.count; ++i)
        corners.push_back(partition.vertices[polygons.vertices[ring.first + i]]);
    }
  }
  return all;
}

std::vector<double> region_areas(const Partition& partition) {
  std::vector<std::int64_t> twice(partition.regions + 1, 0);
  const Point2 o = partition.vertices.empty() ? Point2{} : partition.vertices.front();
  for (const PartitionEdge& e : partition.edges) {
    const Point2 a = partition.vertices[e.from], b = partition.vertices[e.to];
    const std::int64_t part =
        static_cast<std::int64_t>(a.x - o.x) * (b.y - o.y) - static_cast<std::int64_t>(b.x - o.x) * (a.y - o.y);
    twice[e.left] += part;
    twice[e.right] -= part;
  }
  twice[kOutside] = 0;
  std::vector<double> areas;
  for (const std::int64_t t : twice) areas.push_back(static_cast<double>(t) * 0.5e-6);
  return areas;
}

}  // namespace ilot
