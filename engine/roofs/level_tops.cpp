// SPDX-License-Identifier: Apache-2.0
#include "engine/roofs/level_tops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "kernels/outlines/hull.h"

namespace ilot {
namespace {

constexpr std::array kReachSteps{2.0, 1.5, 1.1};  // of one point of a top to the next; less where that joins several
constexpr std::size_t kFewest = 5;
constexpr std::size_t kMembersPerOther = 5;  // within the hull
constexpr double kLeastCover = 0.25;         // of the hull, of what its points stand for
constexpr double kLargestTop = 10;           // m2 that its points stand for; more would be a plane by itself
constexpr double kSmallPlane = 4;            // m2 that the points of a plane stand for; below, a top may take them ...
constexpr double kMostOf = 0.6;              // ... when it takes so much of them or the plane is no surface

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
      : site_(site),
        planes_(planes),
        all_(site.points, everyone()),
        no_surface_(torn()),
        free_(site.points, free_points()) {}

  void run() {
    std::vector<std::pair<std::size_t, std::uint32_t>> seeds;  // by the points around them
    for (const std::uint32_t i : free_points()) {
      const std::size_t around = level_around(i, site_.points[i].z).size();
      if (around + 1 >= kFewest / 2) seeds.emplace_back(around, i);
    }
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::pair(b.first, a.second) < std::pair(a.first, b.second); });
    for (const auto& [around, seed] : seeds) {
      if (!is_free(seed) || tried_[seed] != 0) continue;
      Indices top;
      for (const double steps : kReachSteps) {
        reach_ = steps * planes_.step;
        top = grown_from(seed, mean_height(grown_from(seed, site_.points[seed].z)));
        if (top.size() < kFewest || is_large(top) || !is_surface(top) || !takes_most(top)) continue;
        add(top);
        top.clear();
        break;
      }
      for (const std::uint32_t i : top) tried_[i] = 1;  // what grows from them is much the same
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
    return plane <= given_ && is_small(plane);
  }

  bool is_small(std::uint32_t plane) const {
    return planes_.planes[plane - 1].points * planes_.step * planes_.step < kSmallPlane;
  }

  // Small planes with many points off them in the midst of their own: tops of several boxes taken for one.
  std::set<std::uint32_t> torn() const {
    std::map<std::uint32_t, Indices> members;
    for (const std::uint32_t i : everyone())
      if (planes_.of_point[i] != 0 && is_small(planes_.of_point[i])) members[planes_.of_point[i]].push_back(i);
    std::set<std::uint32_t> planes;
    for (const auto& [plane, points] : members)
      if (others_within(hull_of(points), planes_.planes[plane - 1]) * kMembersPerOther > points.size())
        planes.insert(plane);
    return planes;
  }

  std::vector<Point2> hull_of(const Indices& points) const {
    std::vector<Point2> places, hull;
    for (const std::uint32_t i : points) places.push_back(millimetres(site_.points[i]));
    for (const std::uint32_t v : convex_hull(places)) hull.push_back(places[v]);
    return hull;
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
    const Vec3 p = site_.points[i];
    Indices found;
    free_.between(p.x - reach_, p.x + reach_, [&](std::uint32_t j) {
      const Vec3 q = site_.points[j];
      const double dx = q.x - p.x, dy = q.y - p.y;
      if (j == i || !is_free(j) || dx * dx + dy * dy > reach_ * reach_) return;
      if (std::abs(q.z - height) <= planes_.epsilon) found.push_back(j);
    });
    return found;
  }

  bool is_large(const Indices& top) const {
    return static_cast<double>(top.size()) * planes_.step * planes_.step > kLargestTop;
  }

  // Until it is too large.
  Indices grown_from(std::uint32_t seed, double height) {
    Indices top{seed};
    grown_[seed] = ++growth_;
    for (std::size_t next = 0; next < top.size() && !is_large(top); ++next)
      for (const std::uint32_t j : level_around(top[next], height))
        if (std::exchange(grown_[j], growth_) != growth_) top.push_back(j);
    std::sort(top.begin(), top.end());
    return top;
  }

  bool is_surface(const Indices& top) const {
    const std::vector<Point2> hull = hull_of(top);
    double twice_area = 0;
    for (std::size_t i = 1; i + 1 < hull.size(); ++i)
      twice_area += static_cast<double>(orient2d(hull[0], hull[i], hull[i + 1]));
    const double stood_for = static_cast<double>(top.size()) * planes_.step * planes_.step;
    if (twice_area * 0.5e-6 < kLeastCover * stood_for) return false;
    RoofPlane level;
    level.c = mean_height(top);
    return others_within(hull, level) * kMembersPerOther <= top.size();
  }

  // Points off the plane.
  std::size_t others_within(std::span<const Point2> hull, const RoofPlane& plane) const {
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
      const Vec3 at = site_.points[i];
      const double lean = std::sqrt(1 + plane.gx * plane.gx + plane.gy * plane.gy);
      others += std::abs(at.z - plane.at(at.x, at.y)) > 2 * planes_.epsilon * lean;
    });
    return others;
  }

  // Points of every plane in the top.
  std::map<std::uint32_t, std::uint32_t> taken_by(const Indices& top) const {
    std::map<std::uint32_t, std::uint32_t> taken;
    for (const std::uint32_t i : top)
      if (planes_.of_point[i] != 0) ++taken[planes_.of_point[i]];
    return taken;
  }

  bool is_most(std::uint32_t plane, std::uint32_t points) const {
    return points >= kMostOf * planes_.planes[plane - 1].points;
  }

  bool takes_most(const Indices& top) const {
    const auto taken = taken_by(top);
    return std::all_of(taken.begin(), taken.end(), [&](const auto& entry) {
      return no_surface_.contains(entry.first) || is_most(entry.first, entry.second);
    });
  }

  // A plane that lost most of its points to it loses the others too.
  void add(const Indices& top) {
    for (const auto& [plane, points] : taken_by(top)) {
      if (is_most(plane, points)) std::replace(planes_.of_point.begin(), planes_.of_point.end(), plane, 0u);
      planes_.planes[plane - 1].points -= points;
    }
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
  std::vector<std::uint8_t> tried_ = std::vector<std::uint8_t>(site_.points.size(), 0);
  std::vector<std::uint32_t> grown_ = std::vector<std::uint32_t>(site_.points.size(), 0);  // the last growth with it
  std::uint32_t growth_ = 0;
  double reach_ = kReachSteps.front() * planes_.step;
  std::size_t given_ = planes_.planes.size();  // planes that were there before
  ByPlace all_;
  std::set<std::uint32_t> no_surface_;  // planes
  ByPlace free_;
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
