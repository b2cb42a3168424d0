// SPDX-License-Identifier: Apache-2.0
// Sets of points in a plane, and the Delaunay triangulation computed from its definition.
#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/delaunay/delaunay.h"

namespace ilot::test {

struct PlaneSet {
  std::string name;
  std::vector<Point2> points;
};

inline std::int32_t draw_within(Rng& rng, std::int32_t reach) {
  return static_cast<std::int32_t>(rng.below(2 * static_cast<std::uint64_t>(reach) + 1)) - reach;
}

// Returns sets of about n points each: uniform, lattices full of cocircular points, circles and near-circles, lines,
// near-lines, duplicates, clusters far apart, and the ends of the range.
inline std::vector<PlaneSet> plane_sets(std::uint32_t n, std::uint64_t key) {
  Rng rng(key);
  std::vector<PlaneSet> sets(12);
  const std::int32_t far = kMaxPlaneCoordinate;
  const std::int32_t step = 1 + static_cast<std::int32_t>(rng.below(100));
  const auto columns = static_cast<std::int32_t>(1 + rng.below(n + 1));
  const char* names[] = {"uniform",      "lattice",    "small",    "circle", "line",    "near line",
                         "leaning line", "duplicates", "clusters", "far",    "corners", "near circle"};
  for (std::size_t s = 0; s < sets.size(); ++s) sets[s].name = names[s];
  const Point2 ring[] = {{25, 0}, {24, 7}, {20, 15}, {15, 20}, {7, 24}, {0, 25}};
  for (std::uint32_t u = 0; u < n; ++u) {
    const auto i = static_cast<std::int32_t>(u);
    sets[0].points.push_back({draw_within(rng, 1000000), draw_within(rng, 1000000)});
    sets[1].points.push_back({i % columns * step, i / columns * step});
    sets[2].points.push_back({draw_within(rng, 4), draw_within(rng, 4)});
    const Point2 q = ring[rng.below(6)];
    sets[3].points.push_back({rng.below(2) ? q.x : -q.x, rng.below(2) ? q.y : -q.y});
    sets[4].points.push_back({i * 7 - 50, 3});
    sets[5].points.push_back({draw_within(rng, 1000000), draw_within(rng, 1)});
    const std::int32_t along = draw_within(rng, 300);
    sets[6].points.push_back({along * 1000, along * 3001 + (rng.below(8) == 0 ? 1 : 0)});
    sets[7].points.push_back({static_cast<std::int32_t>(rng.below(3)), static_cast<std::int32_t>(rng.below(2))});
    const std::int32_t home = static_cast<std::int32_t>(rng.below(3)) * 200000000;
    sets[8].points.push_back({home + draw_within(rng, 3), home / 2 + draw_within(rng, 3)});
    sets[9].points.push_back({draw_within(rng, far), draw_within(rng, far)});
    sets[11].points.push_back({q.x * 20000000 + draw_within(rng, 1), q.y * 20000000 - draw_within(rng, 1)});
    sets[10].points.push_back({rng.below(2) ? far : -far, rng.below(2) ? far : -far});
    if (rng.below(3) == 0) sets[10].points.back() = {draw_within(rng, 2), draw_within(rng, 2)};
  }
  return sets;
}

// A triangle given by its positions, smallest first, counter-clockwise.
using PlacedTriangle = std::array<Point2, 3>;

inline PlacedTriangle placed(Point2 a, Point2 b, Point2 c) {
  PlacedTriangle t{a, b, c};
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

inline std::vector<PlacedTriangle> placed_triangles(const Triangulation& t, const std::vector<Point2>& points) {
  std::vector<PlacedTriangle> all;
  for (std::size_t i = 0; i < t.corner.size(); i += 3)
    all.push_back(placed(points[t.corner[i]], points[t.corner[i + 1]], points[t.corner[i + 2]]));
  std::sort(all.begin(), all.end());
  return all;
}

// Returns all triangles without a point in their circumcircle. O(n^4).
inline std::vector<PlacedTriangle> empty_circle_triangles(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<PlacedTriangle> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Point2 a = points[i];
        const std::int64_t turn = orient2d(a, points[j], points[k]);
        if (turn == 0) continue;
        const Point2 b = points[turn > 0 ? j : k], c = points[turn > 0 ? k : j];
        const bool empty = std::none_of(points.begin(), points.end(),
                                        [&](Point2 d) { return d != a && d != b && d != c && in_circle(a, b, c, d); });
        if (empty) all.push_back(placed(a, b, c));
      }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace ilot::test
