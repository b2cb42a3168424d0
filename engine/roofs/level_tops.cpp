// SPDX-License-Identifier: Apache-2.0
#include "engine/roofs/level_tops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "kernels/outlines/hull.h"

namespace ilot {
namespace {

constexpr double kReachSteps = 2;
constexpr std::size_t kFewest = 5;
constexpr std::size_t kMembersPerOther = 5;  // within the hull
constexpr double kLeastCover = 0.25;         // of the hull, of what its points stand for
constexpr double kSmallPlane = 2;            // m2 that the points of a plane stand for; below, a top may take them ...
constexpr double kMostOf = 0.6;              // ... when it takes so much of them: a slope is no top

using Indices = std::vector<std::uint32_t>;

Point2 millimetres(Vec3 p) {
  return {static_cast<std::int32_t>(std::lround(p.x * 1000)), static_cast<std::int32_t>(std::lround(p.y * 1000))};
}

// Points by x, so that those near a place are found without looking at all.
class ByPlace {
 public:
  ByPlace(const std::vector<Vec3>& points, Indices which) : points_(points), order_(std::move(which)) {
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(points[a].x, a) < std::pair(points[b].x, b); });
  }

  template <class Visit>
  void between(double low_x, double high_x, Visit visit) const {
    auto at = std::lower_bound(order_.begin(), order_.end(), low_x,
                               [&](std::uint32_t i, double x) { return points_[i].x < x; });
    for (; at != order_.end() && points_[*at].x <= high_x; ++at) visit(*at);
  }

 private:
  const std::vector<Vec3>& points_;
  Indices order_;
};

class TopFinder {
 public:
  TopFinder(const RoofSite& site, RoofPlanes& planes)
      : site_(site), planes_(planes), free_(site.points, free_points()), all_(site.points, everyone()) {}

  void run() {
    std::vector<std::pair<std::size_t, std::uint32_t>> seeds;  // by the points around them
    for (const std::uint32_t i : free_points()) {
      const std::size_t around = level_around(i, site_.points[i].z).size();
      if (around + 1 >= kFewest / 2) seeds.emplace_back(around, i);
    }
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::pair(b.first, a.second) < std::pair(a.first, b.second); });
    for (const auto& [around, seed] : seeds) {
      if (!is_free(seed)) continue;
      Indices top = grown_from(seed, site_.points[seed].z);
      top = grown_from(seed, mean_height(top));
      if (top.size() >= kFewest && is_surface(top) && takes_most(top)) add(top);
    }
  }

 private:
  Indices everyone() const {
    Indices all(site_.points.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  // Without a plane, or on one so small that it may be a top seen badly.
  bool is_free(std::uint32_t i) const {
    if (planes_.on_wall[i] != 0) return false;
    const std::uint32_t plane = planes_.of_point[i];
    if (plane == 0) return true;
    return plane <= given_ && planes_.planes[plane - 1].points * planes_.step * planes_.step < kSmallPlane;
  }

  Indices free_points() const {
    Indices free = everyone();
    std::erase_if(free, [&](std::uint32_t i) { return !is_free(i); });
    return free;
  }

  double mean_height(const Indices& top) const {
    double z = 0;
    for (const std::uint32_t i : top) z += site_.points[i].z / static_cast<double>(top.size());
    return z;
  }

  // Free points around one of them, at a height.
  Indices level_around(std::uint32_t i, double height) const {
    const double reach = kReachSteps * planes_.step;
    const Vec3 p = site_.points[i];
    Indices found;
    free_.between(p.x - reach, p.x + reach, [&](std::uint32_t j) {
      const Vec3 q = site_.points[j];
      const double dx = q.x - p.x, dy = q.y - p.y;
      if (j == i || !is_free(j) || dx * dx + dy * dy > reach * reach) return;
      if (std::abs(q.z - height) <= planes_.epsilon) found.push_back(j);
    });
    return found;
  }

  Indices grown_from(std::uint32_t seed, double height) const {
    Indices top{seed};
    for (std::size_t next = 0; next < top.size(); ++next)
      for (const std::uint32_t j : level_around(top[next], height))
        if (std::find(top.begin(), top.end(), j) == top.end()) top.push_back(j);
    std::sort(top.begin(), top.end());
    return top;
  }

  bool is_surface(const Indices& top) const {
    std::vector<Point2> places;
    for (const std::uint32_t i : top) places.push_back(millimetres(site_.points[i]));
    std::vector<Point2> hull;
    for (const std::uint32_t v : convex_hull(places)) hull.push_back(places[v]);
    double twice_area = 0;
    for (std::size_t i = 1; i + 1 < hull.size(); ++i)
      twice_area += static_cast<double>(orient2d(hull[0], hull[i], hull[i + 1]));
    const double stood_for = static_cast<double>(top.size()) * planes_.step * planes_.step;
    if (twice_area * 0.5e-6 < kLeastCover * stood_for) return false;
    return others_within(hull, mean_height(top)) * kMembersPerOther <= top.size();
  }

  std::size_t others_within(std::span<const Point2> hull, double height) const {
    std::int32_t low = hull[0].x, high = low;
    for (const Point2 v : hull) {
      low = std::min(low, v.x);
      high = std::max(high, v.x);
    }
    std::size_t others = 0;
    all_.between(low * 0.001, high * 0.001, [&](std::uint32_t i) {
      const Point2 p = millimetres(site_.points[i]);
      for (std::size_t k = 0; k < hull.size(); ++k)
        if (orient2d(hull[k], hull[(k + 1) % hull.size()], p) <= 0) return;
      others += std::abs(site_.points[i].z - height) > 2 * planes_.epsilon;
    });
    return others;
  }

  // Of every plane whose points it has; of two small slopes no top is made.
  bool takes_most(const Indices& top) const {
    std::map<std::uint32_t, std::uint32_t> taken;
    for (const std::uint32_t i : top) ++taken[planes_.of_point[i]];
    return std::all_of(taken.begin(), taken.end(), [&](const auto& entry) {
      return entry.first == 0 || entry.second >= kMostOf * planes_.planes[entry.first - 1].points;
    });
  }

  // Planes that lost points to it lose them all.
  void add(const Indices& top) {
    std::set<std::uint32_t> lost;
    for (const std::uint32_t i : top) lost.insert(planes_.of_point[i]);
    for (std::uint32_t& label : planes_.of_point)
      if (label != 0 && lost.contains(label)) label = 0;
    RoofPlane plane;
    plane.c = mean_height(top);
    plane.lowest = plane.highest = site_.points[top[0]].z;
    const auto label = static_cast<std::uint32_t>(planes_.planes.size() + 1);
    for (const std::uint32_t i : top) {
      if (std::abs(site_.points[i].z - plane.c) > planes_.epsilon) continue;
      planes_.of_point[i] = label;
      ++plane.points;
      plane.lowest = std::min(plane.lowest, site_.points[i].z);
      plane.highest = std::max(plane.highest, site_.points[i].z);
    }
    planes_.planes.push_back(plane);
  }

  const RoofSite& site_;
  RoofPlanes& planes_;
  std::size_t given_ = planes_.planes.size();  // planes that were there before
  ByPlace free_, all_;
};

void drop_empty_planes(RoofPlanes& planes) {
  std::vector<std::uint32_t> number(planes.planes.size() + 1, 0);
  for (const std::uint32_t label : planes.of_point) number[label] = 1;
  number[0] = 0;
  std::uint32_t kept = 0;
  for (std::size_t p = 1; p < number.size(); ++p) {
    if (number[p] == 0) continue;
    planes.planes[kept] = planes.planes[p - 1];
    number[p] = ++kept;
  }
  planes.planes.resize(kept);
  for (std::uint32_t& label : planes.of_point) label = number[label];
}

}  // namespace

void add_level_tops(const RoofSite& site, RoofPlanes& planes) {
  if (planes.step <= 0) return;
  TopFinder(site, planes).run();
  drop_empty_planes(planes);
}

}  // namespace ilot
