// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/thinning.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "kernels/delaunay/constrained.h"

namespace ilot {
namespace {

// Squared distance of p from the segment a-b.
double squared_distance_to(Point2 p, Point2 a, Point2 b) {
  const std::int64_t abx = b.x - a.x, aby = b.y - a.y, apx = p.x - a.x, apy = p.y - a.y;
  const std::int64_t along = abx * apx + aby * apy, length2 = abx * abx + aby * aby;
  if (along <= 0) return static_cast<double>(squared_distance(p, a));
  if (along >= length2) return static_cast<double>(squared_distance(p, b));
  const auto across = static_cast<double>(orient2d(a, b, p));
  return across * across / static_cast<double>(length2);
}

// Places in square cells, to be asked which of them lie in a box.
class PlaceGrid {
 public:
  PlaceGrid(std::span<const Point2> places) : places_(places) {
    if (places.empty()) return;
    Point2 high = places[0];
    low_ = places[0];
    for (const Point2 p : places) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double area = (1.0 + high.x - low_.x) * (1.0 + high.y - low_.y);
    cell_ = 1 + static_cast<std::int64_t>(std::sqrt(area / static_cast<double>(places.size())));
    for (std::uint32_t i = 0; i < places.size(); ++i) cells_.emplace_back(row(places[i].y), column(places[i].x), i);
    std::sort(cells_.begin(), cells_.end());
  }

  template <class Use>
  bool any(Point2 low, Point2 high, const Use& use) const {
    for (std::int64_t r = row(low.y); r <= row(high.y); ++r)
      for (auto i = std::lower_bound(cells_.begin(), cells_.end(), std::tuple(r, column(low.x), 0u));
           i != cells_.end() && std::get<0>(*i) == r && std::get<1>(*i) <= column(high.x); ++i)
        if (use(std::get<2>(*i))) return true;
    return false;
  }

 private:
  std::int64_t row(std::int64_t y) const { return (y - low_.y) / cell_; }
  std::int64_t column(std::int64_t x) const { return (x - low_.x) / cell_; }
  std::span<const Point2> places_;
  Point2 low_;
  std::int64_t cell_ = 1;
  std::vector<std::tuple<std::int64_t, std::int64_t, std::uint32_t>> cells_;
};

// Places are the positions in Polygons::vertices; those left out between a place and the next one follow it in its
// ring.
class Thinner {
 public:
  Thinner(const Polygons& polygons, std::span<const Point2> points, double tolerance)
      : polygons_(polygons),
        limit_(tolerance * tolerance),
        ring_(polygons.vertices.size()),
        left_(polygons.rings.size()),
        next_(ring_.size()),
        last_(ring_.size()),
        gone_(ring_.size()),
        pinned_(ring_.size()),
        version_(ring_.size()),
        place_(ring_.size()) {
    std::vector<std::uint8_t> uses(points.size());
    for (const std::uint32_t v : polygons.vertices) uses[v] = static_cast<std::uint8_t>(std::min(2, uses[v] + 1));
    for (std::uint32_t r = 0; r < polygons.rings.size(); ++r) {
      const Ring& ring = polygons.rings[r];
      left_[r] = ring.count;
      for (std::uint32_t i = ring.first; i < ring.first + ring.count; ++i) {
        ring_[i] = r;
        next_[i] = following(i);
        last_[next_[i]] = i;
        place_[i] = points[polygons.vertices[i]];
        pinned_[i] = uses[polygons.vertices[i]] > 1;
      }
    }
    grid_ = PlaceGrid(place_);
  }

  Polygons thin() {
    for (std::uint32_t i = 0; i < ring_.size(); ++i) offer(i);
    while (!queue_.empty()) {
      const Offer offer = queue_.top();
      queue_.pop();
      const std::uint32_t i = offer.place;
      if (gone_[i] || offer.version != version_[i] || left_[ring_[i]] <= 3 || blocked(i)) continue;
      leave_out(i);
    }
    return rest();
  }

 private:
  struct Offer {
    double moved2;         // how far the outline moves
    std::int64_t length2;  // of the new edge
    Point2 at;
    std::uint32_t place, version;
    bool operator<(const Offer& o) const {  // the queue gives the greatest first
      return std::tie(o.moved2, o.length2, o.at, o.place) < std::tie(moved2, length2, at, place);
    }
  };

  std::uint32_t following(std::uint32_t i) const {
    const Ring& ring = polygons_.rings[ring_[i]];
    return i + 1 == ring.first + ring.count ? ring.first : i + 1;
  }

  void offer(std::uint32_t i) {
    ++version_[i];
    if (pinned_[i]) return;
    const Point2 a = place_[last_[i]], b = place_[next_[i]];
    double moved2 = 0;
    for (std::uint32_t k = following(last_[i]); k != next_[i]; k = following(k))
      if (moved2 = std::max(moved2, squared_distance_to(place_[k], a, b)); moved2 >= limit_) return;
    queue_.push({moved2, squared_distance(a, b), place_[i], i, version_[i]});
  }

  // Whether another vertex lies in the triangle that would change sides, its border included.
  bool blocked(std::uint32_t i) const {
    const Point2 a = place_[last_[i]], v = place_[i], b = place_[next_[i]];
    const std::int64_t turn = orient2d(a, v, b);
    if (turn == 0) return false;
    const Point2 p = turn > 0 ? a : b, q = turn > 0 ? b : a;
    const Point2 low{std::min({a.x, v.x, b.x}), std::min({a.y, v.y, b.y})},
        high{std::max({a.x, v.x, b.x}), std::max({a.y, v.y, b.y})};
    return grid_.any(low, high, [&](std::uint32_t k) {
      const Point2 c = place_[k];
      return !gone_[k] && c != a && c != v && c != b && orient2d(p, v, c) >= 0 && orient2d(v, q, c) >= 0 &&
             orient2d(q, p, c) >= 0;
    });
  }

  void leave_out(std::uint32_t i) {
    gone_[i] = 1;
    --left_[ring_[i]];
    next_[last_[i]] = next_[i];
    last_[next_[i]] = last_[i];
    offer(last_[i]);
    offer(next_[i]);
  }

  // Starts stay the smallest vertex of their ring.
  Polygons rest() const {
    Polygons out;
    out.count = polygons_.count;
    for (const Ring& ring : polygons_.rings) {
      Ring thin{static_cast<std::uint32_t>(out.vertices.size()), 0, ring.polygon};
      std::uint32_t start = kNoEdge;
      for (std::uint32_t i = ring.first; i < ring.first + ring.count; ++i)
        if (!gone_[i] && (start == kNoEdge || place_[i] < place_[start])) start = i;
      std::uint32_t i = start;
      do {
        out.vertices.push_back(polygons_.vertices[i]);
        ++thin.count;
        i = next_[i];
      } while (i != start);
      out.rings.push_back(thin);
    }
    return out;
  }

  const Polygons& polygons_;
  double limit_;
  std::vector<std::uint32_t> ring_, left_, next_, last_;
  std::vector<std::uint8_t> gone_, pinned_;
  std::vector<std::uint32_t> version_;
  std::vector<Point2> place_;
  PlaceGrid grid_{{}};
  std::priority_queue<Offer> queue_;
};

}  // namespace

Polygons thin_rings(const Polygons& polygons, std::span<const Point2> points, double tolerance) {
  return Thinner(polygons, points, tolerance).thin();
}

std::vector<std::uint32_t> fill_polygons(const Polygons& polygons, std::span<const Point2> points) {
  std::vector<std::uint32_t> vertices = polygons.vertices;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto local = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  std::vector<Point2> places;
  for (const std::uint32_t v : vertices) places.push_back(points[v]);
  std::vector<Segment> segments;
  for (const Ring& ring : polygons.rings)
    for (std::uint32_t i = 0; i < ring.count; ++i)
      segments.emplace_back(local(polygons.vertices[ring.first + i]),
                            local(polygons.vertices[ring.first + (i + 1) % ring.count]));
  Triangulation t = delaunay(places);
  const Constraints constraints = insert_segments(t, places, segments);
  const std::vector<std::uint8_t> inside = triangles_inside(t, constraints, segments);
  std::vector<std::uint32_t> corner;
  for (std::size_t i = 0; i < t.corner.size(); ++i)
    if (inside[i / 3]) corner.push_back(vertices[t.corner[i]]);
  return corner;
}

}  // namespace ilot
