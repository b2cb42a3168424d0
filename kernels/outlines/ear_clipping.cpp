// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/ear_clipping.h"

#include <algorithm>
#include <limits>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

using IndexLoop = std::vector<std::uint32_t>;

double doubled_area_of(std::span<const FlatPoint> points, const IndexLoop& loop) {
  return doubled_area<double>(loop.size(), [&](std::size_t i) { return points[loop[i]]; });
}

bool same(FlatPoint a, FlatPoint b) {
  return a.x == b.x && a.y == b.y;
}

bool in_triangle(FlatPoint p, FlatPoint a, FlatPoint b, FlatPoint c) {
  return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
}

// Returns the place in `outer` of a corner that sees corner `from` of a hole. The ray to the right meets an edge, and
// the right end of the edge is visible unless reflex corners are between. In that case the reflex corner at the least
// angle to the ray is visible.
std::size_t visible_corner(std::span<const FlatPoint> points, const IndexLoop& outer, FlatPoint from) {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t end = 0;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const std::size_t j = i + 1 == outer.size() ? 0 : i + 1;
    const FlatPoint a = points[outer[i]], b = points[outer[j]];
    if (!(a.y <= from.y && from.y <= b.y) || a.y == b.y) continue;  // counter-clockwise: upward edges lie to the right
    const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x < from.x || x >= nearest) continue;
    nearest = x;
    end = a.x > b.x ? i : j;
    if (from.y == a.y) end = i;
    if (from.y == b.y) end = j;
  }
  const FlatPoint hit{nearest, from.y}, tip = points[outer[end]];
  if (!(nearest < std::numeric_limits<double>::infinity()) || tip.y == from.y) return end;
  std::size_t best = end;
  double best_slope = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const FlatPoint p = points[outer[i]];
    if (p.x < from.x || same(p, tip)) continue;
    const bool inside = tip.y < from.y ? in_triangle(p, from, tip, hit) : in_triangle(p, from, hit, tip);
    if (!inside) continue;
    const FlatPoint before = points[outer[i == 0 ? outer.size() - 1 : i - 1]];
    const FlatPoint after = points[outer[i + 1 == outer.size() ? 0 : i + 1]];
    if (orient2d(before, p, after) > 0) continue;
    const double slope = std::abs(p.y - from.y) / std::max(p.x - from.x, std::numeric_limits<double>::min());
    if (slope >= best_slope) continue;
    best_slope = slope;
    best = i;
  }
  return best;
}

void link_hole(std::span<const FlatPoint> points, IndexLoop& outer, IndexLoop hole) {
  const auto rightmost = std::max_element(hole.begin(), hole.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a].x < points[b].x || (points[a].x == points[b].x && points[a].y < points[b].y);
  });
  std::rotate(hole.begin(), rightmost, hole.end());
  const std::size_t at = visible_corner(points, outer, points[hole.front()]);
  hole.push_back(hole.front());
  hole.push_back(outer[at]);
  outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(at) + 1, hole.begin(), hole.end());
}

bool is_ear(std::span<const FlatPoint> points, const IndexLoop& loop, std::size_t before, std::size_t at,
            std::size_t after) {
  const FlatPoint a = points[loop[before]], b = points[loop[at]], c = points[loop[after]];
  if (orient2d(a, b, c) <= 0) return false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const FlatPoint p = points[loop[i]];
    if (i == before || i == at || i == after || same(p, a) || same(p, b) || same(p, c)) continue;
    if (in_triangle(p, a, b, c)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const FlatPoint> points,
                                                      std::span<const std::vector<std::uint32_t>> rings) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (rings.empty() || rings[0].size() < 3) return triangles;
  IndexLoop loop = rings[0];
  if (doubled_area_of(points, loop) < 0) std::reverse(loop.begin(), loop.end());
  std::vector<IndexLoop> holes;
  for (const IndexLoop& ring : rings.subspan(1))
    if (ring.size() >= 3) holes.push_back(ring);
  const auto reach = [&](const IndexLoop& hole) {
    double x = points[hole[0]].x;
    for (const std::uint32_t i : hole) x = std::max(x, points[i].x);
    return x;
  };
  std::stable_sort(holes.begin(), holes.end(),
                   [&](const IndexLoop& a, const IndexLoop& b) { return reach(a) > reach(b); });
  for (IndexLoop& hole : holes) {
    if (doubled_area_of(points, hole) > 0) std::reverse(hole.begin(), hole.end());
    link_hole(points, loop, std::move(hole));
  }
  std::size_t at = 0, refused = 0;
  while (loop.size() > 3) {
    if (at >= loop.size()) at = 0;
    const std::size_t before = at == 0 ? loop.size() - 1 : at - 1, after = at + 1 == loop.size() ? 0 : at + 1;
    // After a whole round without an ear the rest has no area or crosses itself, so any corner is cut off.
    if (refused < loop.size() && !is_ear(points, loop, before, at, after)) {
      ++at;
      ++refused;
      continue;
    }
    triangles.push_back({loop[before], loop[at], loop[after]});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(at));
    if (refused < loop.size() + 1) refused = 0;
  }
  triangles.push_back({loop[0], loop[1], loop[2]});
  return triangles;
}

}  // namespace ilot
