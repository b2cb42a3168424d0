// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/alpha_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot {
namespace {

struct Corners {
  std::array<std::uint32_t, 3> v;
  std::array<Point2, 3> p;
};

Corners corners_of(const Triangulation& t, std::size_t triangle, std::span<const Point2> points) {
  const std::uint32_t a = t.corner[3 * triangle], b = t.corner[3 * triangle + 1], c = t.corner[3 * triangle + 2];
  return {{a, b, c}, {points[a], points[b], points[c]}};
}

// Squared lengths in ascending order, so that rounding does not depend on the order of the corners.
std::array<double, 3> squared_edges(const std::array<Point2, 3>& p) {
  double a = static_cast<double>(squared_distance(p[0], p[1])), b = static_cast<double>(squared_distance(p[1], p[2])),
         c = static_cast<double>(squared_distance(p[2], p[0]));
  if (b < a) std::swap(a, b);
  if (c < b) std::swap(b, c);
  if (b < a) std::swap(a, b);
  return {a, b, c};
}

// Circumradius <= reach. With edges a, b, c and area K the circumradius is abc / 4K.
bool circle_fits(const std::array<Point2, 3>& p, double reach) {
  const std::array<double, 3> d = squared_edges(p);
  const double twice_area = static_cast<double>(orient2d(p[0], p[1], p[2]));
  return d[0] * d[1] * d[2] <= 4 * (reach * reach) * (twice_area * twice_area);
}

bool edges_fit(const Corners& c, double reach, std::span<const std::int32_t> height) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    std::int64_t d2 = squared_distance(c.p[i], c.p[j]);
    if (!height.empty()) {
      const std::int64_t dz = height[c.v[i]] - height[c.v[j]];
      d2 += dz * dz;
    }
    if (static_cast<double>(d2) > reach * reach) return false;
  }
  return true;
}

bool in_shape(const Corners& c, const ShapeParams& params) {
  const auto& v = c.v;
  if (!params.label.empty() && (params.label[v[0]] != params.label[v[1]] || params.label[v[1]] != params.label[v[2]]))
    return false;
  const double reach = std::max({params.reach[v[0]], params.reach[v[1]], params.reach[v[2]]});
  if (params.rule == TriangleRule::kCircumradius) return circle_fits(c.p, reach);
  return edges_fit(c, reach, params.height) && circle_fits(c.p, kRadiusPerEdge * reach);
}

}  // namespace

std::vector<std::uint8_t> shape_triangles(const Triangulation& t, std::span<const Point2> points,
                                          const ShapeParams& params) {
  std::vector<std::uint8_t> keep(t.triangles());
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = in_shape(corners_of(t, i, points), params) ? 1 : 0;
  return keep;
}

std::uint32_t owner(const Triangulation& t, std::size_t triangle, std::span<const Point2> points,
                    std::span<const float> reach) {
  const Corners c = corners_of(t, triangle, points);
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    const float mine = reach[c.v[i]], other = reach[c.v[best]];
    if (mine > other || (mine == other && c.p[i] < c.p[best])) best = i;
  }
  return c.v[best];
}

std::int64_t shape_halo(TriangleRule rule, double largest) {
  const double radius = rule == TriangleRule::kCircumradius ? largest : kRadiusPerEdge * largest;
  return static_cast<std::int64_t>(std::ceil(2 * radius)) + 1;
}

std::vector<std::uint32_t> owned_triangles(const Triangulation& t, std::span<const Point2> points,
                                           const ShapeParams& params, std::span<const std::uint8_t> own) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i < t.triangles(); ++i)
    if (own[owner(t, i, points, params.reach)] && in_shape(corners_of(t, i, points), params))
      triangles.push_back(static_cast<std::uint32_t>(i));
  return triangles;
}

void keep_enclosed(const Triangulation& t, std::span<std::uint8_t> keep) {
  std::vector<std::uint8_t> outside(keep.size());
  std::vector<std::uint32_t> stack;
  const auto reach = [&](std::uint32_t triangle) {
    if (keep[triangle] || outside[triangle]) return;
    outside[triangle] = 1;
    stack.push_back(triangle);
  };
  for (std::uint32_t e = 0; e < t.twin.size(); ++e)
    if (t.twin[e] == kNoEdge) reach(e / 3);
  while (!stack.empty()) {
    const std::uint32_t triangle = stack.back();
    stack.pop_back();
    for (std::uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
      if (t.twin[e] != kNoEdge) reach(t.twin[e] / 3);
  }
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = outside[i] ? 0 : 1;
}

}  // namespace ilot
