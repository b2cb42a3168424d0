// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/hull.h"

#include <algorithm>
#include <numeric>

namespace ilot {
namespace {

// A vector between hull points, and how far points extend along and across it.
struct Direction {
  std::int64_t x = 0, y = 0;
  std::int64_t along(Point2 p, Point2 origin) const { return x * (p.x - origin.x) + y * (p.y - origin.y); }
  std::int64_t across(Point2 p, Point2 origin) const { return x * (p.y - origin.y) - y * (p.x - origin.x); }
};

// A box around all points whose base is the hull edge from `origin` on. Its extents are multiples of the length of that
// edge.
struct EdgeBox {
  Point2 origin;
  Direction edge;
  std::int64_t low = 0, high = 0, top = 0;
  double area() const {
    const double squared = static_cast<double>(edge.x * edge.x + edge.y * edge.y);
    return static_cast<double>(high - low) / squared * static_cast<double>(top);
  }
  PlanePosition at(std::int64_t along, std::int64_t across) const {
    const double squared = static_cast<double>(edge.x * edge.x + edge.y * edge.y);
    const double a = static_cast<double>(along) / squared, b = static_cast<double>(across) / squared;
    const double x = static_cast<double>(edge.x), y = static_cast<double>(edge.y);
    return {origin.x + a * x - b * y, origin.y + a * y + b * x};
  }
};

}  // namespace

std::vector<std::uint32_t> convex_hull(std::span<const Point2> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  order.erase(
      std::unique(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; }),
      order.end());
  if (order.size() < 3) return order;
  std::vector<std::uint32_t> hull;
  const auto add = [&](std::uint32_t v, std::size_t base) {
    while (hull.size() >= base + 2 && orient2d(points[hull[hull.size() - 2]], points[hull.back()], points[v]) <= 0)
      hull.pop_back();
    hull.push_back(v);
  };
  for (const std::uint32_t v : order) add(v, 0);
  const std::size_t base = hull.size() - 1;
  for (std::size_t i = order.size() - 1; i-- > 0;) add(order[i], base);
  hull.pop_back();
  return hull;
}

std::array<PlanePosition, 4> right_angled_outline(std::span<const std::uint32_t> hull, std::span<const Point2> points) {
  if (hull.empty()) return {};
  const std::size_t n = hull.size();
  const auto at = [&](std::size_t i) { return points[hull[i % n]]; };
  if (n < 3) {
    const PlanePosition a{static_cast<double>(at(0).x), static_cast<double>(at(0).y)},
        b{static_cast<double>(at(n - 1).x), static_cast<double>(at(n - 1).y)};
    return {a, b, b, a};
  }
  EdgeBox best;
  std::size_t right = 1, top = 1, left = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 a = at(i), b = at(i + 1);
    EdgeBox box{a, {b.x - a.x, b.y - a.y}};
    const auto along = [&](std::size_t k) { return box.edge.along(at(k), a); };
    const auto across = [&](std::size_t k) { return box.edge.across(at(k), a); };
    right = std::max(right, i + 1);
    while (along(right + 1) > along(right)) ++right;
    top = std::max(top, right);
    while (across(top + 1) > across(top)) ++top;
    left = std::max(left, top);
    while (along(left + 1) < along(left)) ++left;
    box.low = along(left);
    box.high = along(right);
    box.top = across(top);
    if (i == 0 || box.area() < best.area()) best = box;
  }
  return {best.at(best.low, 0), best.at(best.high, 0), best.at(best.high, best.top), best.at(best.low, best.top)};
}

}  // namespace ilot
