// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/edge_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

constexpr std::size_t kLeaf = 8;        // points of a leaf of the tree
constexpr double kShortest = 0x1p-40;   // of an edge's length: shorter stretches are rounding
constexpr double kSlack = 1 + 0x1p-40;  // factor on squared distances, within which equal ones are sought

double coordinate(FlatPoint p, int axis) {
  return axis == 0 ? p.x : p.y;
}

// A k-d tree without nodes: the middle of each range of `order_` splits it. Distances to cells grow axis by axis on the
// way down (Arya and Mount 1993), so that queries from far away skip branches too.
class PointTree {
 public:
  explicit PointTree(std::span<const FlatPoint> points) : points_(points), order_(points.size()), axis_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    low_ = high_ = points[0];
    for (const FlatPoint& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    build(0, order_.size(), low_, high_);
  }

  std::uint32_t nearest(FlatPoint q) const {
    std::uint32_t best = order_[0];
    double least = std::numeric_limits<double>::infinity();
    each_within(q, least, [&](std::uint32_t i, double d2) {
      if (d2 >= least) return;
      least = d2;
      best = i;
    });
    return best;
  }

  // Calls visit(point, squared distance) for all points within `d2` and some more. `d2` may shrink meanwhile.
  template <class Visit>
  void each_within(FlatPoint q, double& d2, Visit visit) const {
    const std::array<double, 2> away{std::max({low_.x - q.x, q.x - high_.x, 0.0}),
                                     std::max({low_.y - q.y, q.y - high_.y, 0.0})};
    descend(0, order_.size(), q, away, d2, visit);
  }

 private:
  void build(std::size_t first, std::size_t end, FlatPoint low, FlatPoint high) {
    if (end - first <= kLeaf) return;
    const std::size_t mid = first + (end - first) / 2;
    const int axis = high.x - low.x >= high.y - low.y ? 0 : 1;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(mid), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return coordinate(points_[a], axis) < coordinate(points_[b], axis);
    });
    axis_[mid] = static_cast<std::uint8_t>(axis);
    FlatPoint below = high, above = low;
    (axis == 0 ? below.x : below.y) = (axis == 0 ? above.x : above.y) = coordinate(points_[order_[mid]], axis);
    build(first, mid, low, below);
    build(mid + 1, end, above, high);
  }

  // `away` is how far q is outside of the range's cell along each axis.
  template <class Visit>
  void descend(std::size_t first, std::size_t end, FlatPoint q, std::array<double, 2> away, double& d2,
               Visit& visit) const {
    if (away[0] * away[0] + away[1] * away[1] > d2) return;
    if (end - first <= kLeaf) {
      for (std::size_t k = first; k < end; ++k) visit(order_[k], squared_distance(points_[order_[k]], q));
      return;
    }
    const std::size_t mid = first + (end - first) / 2;
    const int axis = axis_[mid];
    const double gap = coordinate(q, axis) - coordinate(points_[order_[mid]], axis);
    visit(order_[mid], squared_distance(points_[order_[mid]], q));
    std::array<double, 2> beyond = away;
    beyond[static_cast<std::size_t>(axis)] = std::max(away[static_cast<std::size_t>(axis)], std::abs(gap));
    descend(first, mid, q, gap < 0 ? away : beyond, d2, visit);
    descend(mid + 1, end, q, gap < 0 ? beyond : away, d2, visit);
  }

  std::span<const FlatPoint> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> axis_;  // of the split at each middle
  FlatPoint low_, high_;
};

// Walks one edge from end to end.
class EdgeWalk {
 public:
  EdgeWalk(std::span<const FlatPoint> points, const PointTree& tree, const FlatEdge& edge,
           std::vector<std::uint8_t>& flags)
      : points_(points), tree_(tree), edge_(edge), flags_(flags) {
    length_ = distance(edge.a, edge.b);
    along_ = {(edge.b.x - edge.a.x) / length_, (edge.b.y - edge.a.y) / length_};
  }

  void walk() {
    if (length_ > 0) between(0, tree_.nearest(at(0)), length_, tree_.nearest(at(length_)));
  }

 private:
  // The squared distance of a point from the point of the edge at t is offset - 2 foot t + t^2.
  struct Line {
    double foot = 0, offset = 0;
    friend bool operator==(const Line&, const Line&) = default;
  };

  FlatPoint at(double t) const { return {edge_.a.x + t * along_.x, edge_.a.y + t * along_.y}; }

  Line line_of(std::uint32_t i) const {
    const double x = points_[i].x - edge_.a.x, y = points_[i].y - edge_.a.y;
    return {x * along_.x + y * along_.y, x * x + y * y};
  }

  // p is nearest at `from`, q at `to`. Cells are convex, so a cell that contains both ends contains all between.
  // Otherwise the nearest point at the place where p and q are equally far decides: when it is one of them, their cells
  // meet there, and otherwise the place splits the rest.
  void between(double from, std::uint32_t p, double to, std::uint32_t q) {
    const Line a = line_of(p), b = line_of(q);
    if (a == b) return mark(from, to, p);
    const double meeting = std::clamp((b.offset - a.offset) / (2 * (b.foot - a.foot)), from, to);
    const std::uint32_t r = tree_.nearest(at(meeting));
    const Line c = line_of(r);
    const bool closer = c.offset - 2 * c.foot * meeting < a.offset - 2 * a.foot * meeting;
    const bool splits = c != a && c != b && closer;
    if (!splits || to - from <= kShortest * length_) {
      mark(from, meeting, p);
      mark(meeting, to, q);
      return;
    }
    between(from, p, meeting, r);
    between(meeting, r, to, q);
  }

  // Marks p, whose cell contains the stretch, and all points that are as far from all of it: points at the same place,
  // or mirrored.
  void mark(double from, double to, std::uint32_t p) {
    if (!(to - from > kShortest * length_)) return;
    flags_[p] = 1;
    const FlatPoint middle = at(from + (to - from) / 2);
    const Line line = line_of(p);
    double reach = squared_distance(points_[p], middle) * kSlack;
    tree_.each_within(middle, reach, [&](std::uint32_t i, double) {
      if (line_of(i) == line) flags_[i] = 1;
    });
  }

  std::span<const FlatPoint> points_;
  const PointTree& tree_;
  FlatEdge edge_;
  std::vector<std::uint8_t>& flags_;
  double length_ = 0;
  FlatPoint along_;
};

}  // namespace

std::vector<std::uint8_t> cells_on_edges(std::span<const FlatPoint> points, std::span<const FlatEdge> edges) {
  std::vector<std::uint8_t> flags(points.size(), 0);
  if (points.empty()) return flags;
  const PointTree tree(points);
  for (const FlatEdge& edge : edges) EdgeWalk(points, tree, edge, flags).walk();
  return flags;
}

}  // namespace ilot
