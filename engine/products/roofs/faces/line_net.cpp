// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/line_net.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace ilot {
namespace {

using Wide = __int128;

// Directs the segments from left to right, as vertices ascend, and sorts them.
std::vector<NetSegment> directed(std::span<const NetSegment> segments) {
  std::vector<NetSegment> sorted;
  sorted.reserve(segments.size());
  for (const NetSegment& s : segments)
    if (s.a != s.b) sorted.push_back(s.a < s.b ? s : NetSegment{s.b, s.a, s.border});
  std::sort(sorted.begin(), sorted.end(), [](const NetSegment& s, const NetSegment& t) {
    return std::tie(s.a, s.b, s.border) < std::tie(t.a, t.b, t.border);
  });
  return sorted;
}

// The quotient a / b for b > 0, rounded to the nearest integer, halves up.
std::int32_t rounded_quotient(Wide a, Wide b) {
  const Wide n = 2 * a + b, d = 2 * b;
  Wide q = n / d;
  if (n % d < 0) --q;
  return static_cast<std::int32_t>(q);
}

bool overlap_along_y(const NetSegment& s, const NetSegment& t) {
  return std::max(s.a.y, s.b.y) >= std::min(t.a.y, t.b.y) && std::max(t.a.y, t.b.y) >= std::min(s.a.y, s.b.y);
}

// Adds the rounded point where the interiors of two segments cross. Segments that meet in an end need no other vertex.
void add_crossing(const NetSegment& s, const NetSegment& t, std::vector<Point2>& vertices) {
  const std::int64_t a = orient2d(s.a, s.b, t.a), b = orient2d(s.a, s.b, t.b);
  if (a == 0 || b == 0 || (a > 0) == (b > 0)) return;
  const std::int64_t c = orient2d(t.a, t.b, s.a), d = orient2d(t.a, t.b, s.b);
  if (c == 0 || d == 0 || (c > 0) == (d > 0)) return;
  const Wide from = a > 0 ? Wide{a} : -Wide{a}, all = from + (b > 0 ? Wide{b} : -Wide{b});
  vertices.push_back(
      {t.a.x + rounded_quotient(from * (t.b.x - t.a.x), all), t.a.y + rounded_quotient(from * (t.b.y - t.a.y), all)});
}

std::vector<Point2> vertices_of(const std::vector<NetSegment>& segments) {
  std::vector<Point2> vertices;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    vertices.push_back(segments[i].a);
    vertices.push_back(segments[i].b);
    for (std::size_t j = i + 1; j < segments.size() && segments[j].a.x <= segments[i].b.x; ++j)
      if (overlap_along_y(segments[i], segments[j])) add_crossing(segments[i], segments[j], vertices);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Returns true where a segment passes through the square of half a unit around a point, its left and its lower side
// included. The segment's box must reach the square's box.
bool passes(const NetSegment& s, Point2 p) {
  const std::int64_t dx = std::int64_t{s.b.x} - s.a.x, dy = std::int64_t{s.b.y} - s.a.y;
  const std::int64_t off = orient2d(s.a, s.b, p), width = std::abs(dx) + std::abs(dy);  // twice the corners' offsets
  if (std::abs(off) <= (width - 1) / 2) return true;
  return width % 2 == 0 && std::abs(off) == width / 2 && 2 * off == dx - dy;  // through the lower left corner
}

class Rounding {
 public:
  Rounding(const std::vector<NetSegment>& segments, LineNet& net) : segments_(segments), net_(net) {}

  void run() {
    for (const NetSegment& s : segments_) add(s);
    std::sort(net_.edges.begin(), net_.edges.end(),
              [](const NetEdge& e, const NetEdge& f) { return std::tie(e.from, e.to) < std::tie(f.from, f.to); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < net_.edges.size(); ++i) {
      const NetEdge e = net_.edges[i];
      if (kept > 0 && net_.edges[kept - 1].from == e.from && net_.edges[kept - 1].to == e.to) {
        net_.edges[kept - 1].border ^= e.border;
      } else {
        net_.edges[kept++] = e;
      }
    }
    net_.edges.resize(kept);
  }

 private:
  // Adds the edges of a segment. The vertices on a segment ascend in its direction.
  void add(const NetSegment& s) {
    on_way_.clear();
    const std::int32_t low = std::min(s.a.y, s.b.y), high = std::max(s.a.y, s.b.y);
    const auto first = std::lower_bound(net_.vertices.begin(), net_.vertices.end(), s.a.x,
                                        [](Point2 v, std::int32_t x) { return v.x < x; });
    for (auto v = first; v != net_.vertices.end() && v->x <= s.b.x; ++v) {
      if (v->y < low || v->y > high || !passes(s, *v)) continue;
      const std::int64_t along =
          std::int64_t{v->x - s.a.x} * (s.b.x - s.a.x) + std::int64_t{v->y - s.a.y} * (s.b.y - s.a.y);
      on_way_.emplace_back(along, static_cast<std::uint32_t>(v - net_.vertices.begin()));
    }
    std::sort(on_way_.begin(), on_way_.end());
    for (std::size_t i = 1; i < on_way_.size(); ++i) {
      const std::uint32_t u = on_way_[i - 1].second, v = on_way_[i].second;
      net_.edges.push_back({std::min(u, v), std::max(u, v), s.border});
    }
  }

  const std::vector<NetSegment>& segments_;
  LineNet& net_;
  std::vector<std::pair<std::int64_t, std::uint32_t>> on_way_;
};

}  // namespace

LineNet snap_rounded(std::span<const NetSegment> segments) {
  const std::vector<NetSegment> sorted = directed(segments);
  LineNet net{vertices_of(sorted), {}};
  Rounding(sorted, net).run();
  return net;
}

}  // namespace ilot
