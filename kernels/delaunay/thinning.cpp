// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

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

// The vertices of polygons, by their positions in Polygons::vertices.
struct Places {
  std::span<const std::uint32_t> vertices;
  std::span<const Point2> points;

  Point2 operator[](std::uint32_t i) const { return points[vertices[i]]; }
  std::size_t size() const { return vertices.size(); }
};

// Places in square cells, for queries for the places in a box.
class PlaceGrid {
 public:
  explicit PlaceGrid(Places places) : places_(places) {
    if (places.size() == 0) return;
    Point2 high = places[0];
    low_ = places[0];
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      const Point2 p = places[i];
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double area = (1.0 + high.x - low_.x) * (1.0 + high.y - low_.y);
    cell_ = 1 + static_cast<std::int64_t>(std::sqrt(area / static_cast<double>(places.size())));
    order_.resize(places.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t i, std::uint32_t k) { return std::pair(cell(i), i) < std::pair(cell(k), k); });
  }

  template <class Use>
  bool any(Point2 low, Point2 high, const Use& use) const {
    for (std::int64_t r = row(low.y); r <= row(high.y); ++r) {
      const Cell last{r, column(high.x)};
      for (auto i = std::lower_bound(order_.begin(), order_.end(), Cell{r, column(low.x)},
                                     [&](std::uint32_t k, const Cell&c) { return cell(k) < c; });
           i != order_.end() && cell(*i) <= last; ++i)
        if (use(*i)) return true;
    }
    return false;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;  // row, column

  Cell cell(std::uint32_t i) const { return {row(places_[i].y), column(places_[i].x)}; }
  std::int64_t row(std::int64_t y) const { return (y - low_.y) / cell_; }
  std::int64_t column(std::int64_t x) const { return (x - low_.x) / cell_; }
  Places places_;
  Point2 low_;
  std::int64_t cell_ = 1;
  std::vector<std::uint32_t> order_;  // places by cell, then by index
};

// A heap of items 0 to n - 1. Each item is in the heap or not. The first item comes from an order that the owner
// defines. It needs 8 bytes per item.
template <class Before>
class IndexHeap {
 public:
  IndexHeap(std::size_t items, Before before) : before_(before), at_(items, kNoEdge) { heap_.reserve(items); }

  bool empty() const { return heap_.empty(); }
  std::uint32_t first() const { return heap_[0]; }

  // Call this before a change of the data on which the order of an item in the heap depends.
  void remove(std::uint32_t item) {
    const std::uint32_t at = at_[item];
    if (at == kNoEdge) return;
    at_[item] = kNoEdge;
    const std::uint32_t last = heap_.back();
    heap_.pop_back();
    if (last == item) return;
    put(at, last);
    up(at);
    down(at_[last]);
  }

  void add(std::uint32_t item) {
    heap_.push_back(item);
    at_[item] = static_cast<std::uint32_t>(heap_.size() - 1);
    up(at_[item]);
  }

 private:
  void put(std::uint32_t at, std::uint32_t item) {
    heap_[at] = item;
    at_[item] = at;
  }
  void up(std::uint32_t at) {
    const std::uint32_t item = heap_[at];
    for (; at > 0 && before_(item, heap_[(at - 1) / 2]); at = (at - 1) / 2) put(at, heap_[(at - 1) / 2]);
    put(at, item);
  }
  void down(std::uint32_t at) {
    const std::uint32_t item = heap_[at];
    for (std::uint32_t child = 2 * at + 1; child < heap_.size(); child = 2 * at + 1) {
      if (child + 1 < heap_.size() && before_(heap_[child + 1], heap_[child])) ++child;
      if (!before_(heap_[child], item)) break;
      put(at, heap_[child]);
      at = child;
    }
    put(at, item);
  }

  Before before_;
  std::vector<std::uint32_t> heap_, at_;
};

// Places are the positions in Polygons::vertices. The removed places between a place and the next one follow it in its
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
        moved2_(ring_.size()),
        place_{polygons.vertices, points},
        grid_(place_),
        offers_(ring_.size(), Before{this}) {
    std::vector<std::uint8_t> uses(points.size());
    for (const std::uint32_t v : polygons.vertices) uses[v] = static_cast<std::uint8_t>(std::min(2, uses[v] + 1));
    for (std::uint32_t r = 0; r < polygons.rings.size(); ++r) {
      const Ring& ring = polygons.rings[r];
      left_[r] = ring.count;
      for (std::uint32_t i = ring.first; i < ring.first + ring.count; ++i) {
        ring_[i] = r;
        next_[i] = following(i);
        last_[next_[i]] = i;
        pinned_[i] = uses[polygons.vertices[i]] > 1;
      }
    }
  }

  Polygons thin() {
    for (std::uint32_t i = 0; i < ring_.size(); ++i) offer(i);
    while (!offers_.empty()) {
      const std::uint32_t i = offers_.first();
      offers_.remove(i);
      if (left_[ring_[i]] <= 3 || blocked(i)) continue;
      leave_out(i);
    }
    return rest();
  }

 private:
  // Compares how far the outline moves, then the length of the new edge, then the place.
  struct Before {
    const Thinner* t;
    bool operator()(std::uint32_t i, std::uint32_t k) const {
      if (t->moved2_[i] != t->moved2_[k]) return t->moved2_[i] < t->moved2_[k];
      const std::int64_t a = t->new_length2(i), b = t->new_length2(k);
      return a != b ? a < b : std::pair(t->place_[i], i) < std::pair(t->place_[k], k);
    }
  };

  std::int64_t new_length2(std::uint32_t i) const { return squared_distance(place_[last_[i]], place_[next_[i]]); }

  std::uint32_t following(std::uint32_t i) const {
    const Ring& ring = polygons_.rings[ring_[i]];
    return i + 1 == ring.first + ring.count ? ring.first : i + 1;
  }

  // Call this for a vertex that is not in the heap.
  void offer(std::uint32_t i) {
    if (pinned_[i]) return;
    const Point2 a = place_[last_[i]], b = place_[next_[i]];
    double moved2 = 0;
    for (std::uint32_t k = following(last_[i]); k != next_[i]; k = following(k))
      if (moved2 = std::max(moved2, squared_distance_to(place_[k], a, b)); moved2 >= limit_) return;
    moved2_[i] = moved2;
    offers_.add(i);
  }

  // Whether another vertex is in the triangle that would change sides, or on its border.
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
    offers_.remove(last_[i]);
    offers_.remove(next_[i]);
    next_[last_[i]] = next_[i];
    last_[next_[i]] = last_[i];
    offer(last_[i]);
    offer(next_[i]);
  }

  // The first vertex stays the smallest of its ring.
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
  std::vector<double> moved2_;
  Places place_;
  PlaceGrid grid_;
  IndexHeap<Before> offers_;
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
  std::vector<VertexPair> segments;
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
