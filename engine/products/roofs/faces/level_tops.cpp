// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/level_tops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "kernels/outlines/hull.h"

namespace ilot {
namespace {

constexpr std::array kTopReachSteps{2.0, 1.5, 1.1};  // steps between neighbours; less where tops would be joined
constexpr std::size_t kFewest = 5;
constexpr std::size_t kMembersPerOther = 5;  // points of the top per other point within the hull
// Choice: chimneys and lift shafts are compact; a ring of points is no top.
constexpr double kLeastCover = 0.25;  // area of the hull divided by the area that its points stand for
// Choice: larger tops are found as planes.
constexpr double kLargestTop = 10;  // m2 that its points stand for; a larger one would be a plane by itself
// Choice: a terrace below it can lose its plane to a top.
constexpr double kSmallPlane = 4;          // m2 that the points of a plane stand for; below, a top may take them ...
constexpr std::int32_t kRowHeight = 1000;  // millimetres; height of the rows in which points are searched
constexpr std::size_t kMostPairs =
    1u << 21;  // stored pairs of near points: 8 MiB; further ones are searched again each time
// Derived: more than half, a majority with a margin for borders.
constexpr double kMostOf = 0.6;  // ... when it takes this share of them, or when the plane is no surface

using Indices = std::vector<std::uint32_t>;

// Points in rows along x, each row sorted by x, so that the points in a box are found without examining all points.
class Rows {
 public:
  Rows(const std::vector<Point2>& places, const Indices& which, std::int32_t height)
      : places_(places), height_(std::max(height, 1)) {
    low_y_ = std::numeric_limits<std::int32_t>::max();
    std::int32_t high_y = low_y_;
    for (const std::uint32_t i : which) {
      high_y = low_y_ == std::numeric_limits<std::int32_t>::max() ? places[i].y : std::max(high_y, places[i].y);
      low_y_ = std::min(low_y_, places[i].y);
    }
    if (which.empty()) return;
    rows_ = row_of(high_y) + 1;
    first_.assign(static_cast<std::size_t>(rows_) + 1, 0);
    for (const std::uint32_t i : which) ++first_[static_cast<std::size_t>(row_of(places[i].y))];
    for (std::uint32_t end = 0; std::uint32_t & f : first_) end = f += end;
    order_.resize(which.size());
    for (const std::uint32_t i : which)
      order_[--first_[static_cast<std::size_t>(row_of(places[i].y))]] = {places[i].x, i};
    for (std::int64_t row = 0; row < rows_; ++row) std::sort(row_begin(row), row_begin(row + 1));
  }

  template <class Visit>
  void in_box(Point2 low, Point2 high, Visit visit) const {
    const std::int64_t last = std::min(row_of(high.y), rows_ - 1);
    for (std::int64_t row = std::max<std::int64_t>(row_of(low.y), 0); row <= last; ++row) {
      const auto end = row_begin(row + 1);
      for (auto at = std::lower_bound(row_begin(row), end, std::pair(low.x, 0u)); at != end && at->first <= high.x;
           ++at) {
        const std::int32_t y = places_[at->second].y;
        if (y >= low.y && y <= high.y) visit(at->second);
      }
    }
  }

 private:
  using Placed = std::pair<std::int32_t, std::uint32_t>;  // x and the point

  std::int64_t row_of(std::int32_t y) const {
    const std::int64_t above = std::int64_t{y} - low_y_;
    return above < 0 ? -1 : above / height_;
  }
  std::vector<Placed>::iterator row_begin(std::int64_t row) {
    return order_.begin() + first_[static_cast<std::size_t>(row)];
  }
  std::vector<Placed>::const_iterator row_begin(std::int64_t row) const {
    return order_.begin() + first_[static_cast<std::size_t>(row)];
  }

  const std::vector<Point2>& places_;
  std::int32_t height_, low_y_ = 0;
  std::int64_t rows_ = 0;
  std::vector<std::uint32_t> first_;  // per row, and one more entry: where it begins
  std::vector<Placed> order_;
};

class TopFinder {
 public:
  TopFinder(const RoofSite& site, RoofPlanes& planes)
      : site_(site),
        planes_(planes),
        places_(places_of(site.points)),
        all_(places_, everyone(), kRowHeight),
        no_surface_(torn()) {
    find_neighbours();
  }

  void run() {
    std::vector<std::pair<std::size_t, std::uint32_t>> seeds;  // with the number of points around them
    for (const std::uint32_t i : everyone()) {
      if (free_[i] == 0) continue;
      std::size_t around = 0;
      level_around(i, site_.points[i].z, [&](std::uint32_t) { ++around; });
      if (around + 1 >= kFewest / 2) seeds.emplace_back(around, i);
    }
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::pair(b.first, a.second) < std::pair(a.first, b.second); });
    for (const auto& [around, seed] : seeds) {
      if (free_[seed] == 0 || tried_[seed] != 0) continue;
      Indices top;
      for (const double steps : kTopReachSteps) {
        reach_ = steps * planes_.step;
        top = grown_from(seed, mean_height(grown_from(seed, site_.points[seed].z)));
        if (top.size() < kFewest || is_large(top) || !is_surface(top) || !takes_majority(top)) continue;
        add(top);
        top.clear();
        break;
      }
      for (const std::uint32_t i : top) tried_[i] = 1;  // the tops that grow from them are nearly the same
    }
  }

 private:
  Indices everyone() const {
    Indices all(site_.points.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  static std::vector<Point2> places_of(const std::vector<Vec3>& points) {
    std::vector<Point2> places;
    places.reserve(points.size());
    for (const Vec3& p : points) places.push_back(lattice_point({p.x, p.y}, 1000));
    return places;
  }

  // Returns true for a point without a plane, or on a plane so small that it may be a top that is badly seen.
  bool is_free(std::uint32_t i) const {
    if (planes_.on_wall[i] != 0) return false;
    const std::uint32_t plane = planes_.of_point[i];
    if (plane == 0) return true;
    return is_small(plane);
  }

  bool is_small(std::uint32_t plane) const {
    return planes_.planes[plane - 1].points * planes_.step * planes_.step < kSmallPlane;
  }

  // Returns the small planes that have many points off them in the midst of their own: such a plane joins the tops of
  // more than one box.
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
    for (const std::uint32_t i : points) places.push_back(places_[i]);
    for (const std::uint32_t v : convex_hull(places)) hull.push_back(places[v]);
    return hull;
  }

  // Finds which points are free and, for each of these, the free points within the farthest reach of it.
  void find_neighbours() {
    Indices free = everyone();
    std::erase_if(free, [&](std::uint32_t i) { return !is_free(i); });
    free_.assign(site_.points.size(), 0);
    for (const std::uint32_t i : free) free_[i] = 1;
    rows_.emplace(places_, free, box_reach());
    std::size_t pairs = 0;
    for (const std::uint32_t i : free) {
      for_each_near(i, [&](std::uint32_t) { ++pairs; });
      if (pairs > kMostPairs) return;
    }
    first_.assign(site_.points.size() + 1, 0);
    others_.reserve(pairs);
    for (const std::uint32_t i : free) {
      const auto before = static_cast<std::uint32_t>(others_.size());
      for_each_near(i, [&](std::uint32_t j) { others_.push_back(j); });
      first_[i + 1] = static_cast<std::uint32_t>(others_.size()) - before;
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  std::int32_t box_reach() const { return static_cast<std::int32_t>(std::ceil(std::min(reach_ * 1000 + 1, 1e6))); }

  // Visits the points within reach that were free at the beginning.
  template <class Visit>
  void for_each_near(std::uint32_t i, Visit visit) const {
    const Point2 p = places_[i];
    const std::int32_t reach = box_reach();
    rows_->in_box({p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}, [&](std::uint32_t j) {
      if (j != i && squared_apart(i, j) <= reach_ * reach_) visit(j);
    });
  }

  double squared_apart(std::uint32_t i, std::uint32_t j) const {
    const double dx = site_.points[j].x - site_.points[i].x, dy = site_.points[j].y - site_.points[i].y;
    return dx * dx + dy * dy;
  }

  double mean_height(const Indices& top) const {
    double z = 0;
    for (const std::uint32_t i : top) z += site_.points[i].z / static_cast<double>(top.size());
    return z;
  }

  // Visits the free points around one of them at a height.
  template <class Visit>
  void level_around(std::uint32_t i, double height, Visit visit) const {
    const auto look_at = [&](std::uint32_t j) {
      if (free_[j] == 0 || std::abs(site_.points[j].z - height) > planes_.epsilon) return;
      if (squared_apart(i, j) <= reach_ * reach_) visit(j);
    };
    if (first_.empty()) return for_each_near(i, look_at);
    for (std::uint32_t at = first_[i]; at < first_[i + 1]; ++at) look_at(others_[at]);
  }

  bool is_large(const Indices& top) const {
    return static_cast<double>(top.size()) * planes_.step * planes_.step > kLargestTop;
  }

  // Grows a top from a seed until it is complete or too large.
  Indices grown_from(std::uint32_t seed, double height) {
    Indices top{seed};
    grown_[seed] = ++growth_;
    for (std::size_t next = 0; next < top.size() && !is_large(top); ++next)
      level_around(top[next], height, [&](std::uint32_t j) {
        if (std::exchange(grown_[j], growth_) != growth_) top.push_back(j);
      });
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

  // Counts the points within the hull that are off the plane.
  std::size_t others_within(std::span<const Point2> hull, const RoofPlane& plane) const {
    Point2 low = hull[0], high = low;
    for (const Point2 v : hull) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y)};
    }
    std::size_t others = 0;
    all_.in_box(low, high, [&](std::uint32_t i) {
      const Point2 p = places_[i];
      for (std::size_t k = 0; k < hull.size(); ++k)
        if (orient2d(hull[k], hull[(k + 1) % hull.size()], p) <= 0) return;
      const Vec3 at = site_.points[i];
      const double lean = std::sqrt(1 + plane.gx * plane.gx + plane.gy * plane.gy);
      others += std::abs(at.z - plane.at(at.x, at.y)) > 2 * planes_.epsilon * lean;
    });
    return others;
  }

  // Counts the points of every plane in the top.
  std::map<std::uint32_t, std::uint32_t> taken_by(const Indices& top) const {
    std::map<std::uint32_t, std::uint32_t> taken;
    for (const std::uint32_t i : top)
      if (planes_.of_point[i] != 0) ++taken[planes_.of_point[i]];
    return taken;
  }

  bool is_majority(std::uint32_t plane, std::uint32_t points) const {
    return points >= kMostOf * planes_.planes[plane - 1].points;
  }

  bool takes_majority(const Indices& top) const {
    const auto taken = taken_by(top);
    return std::all_of(taken.begin(), taken.end(), [&](const auto& entry) {
      return no_surface_.contains(entry.first) || is_majority(entry.first, entry.second);
    });
  }

  // Adds the plane of a top. A plane that lost most of its points to the top loses its other points too.
  void add(const Indices& top) {
    for (const auto& [plane, points] : taken_by(top)) {
      if (is_majority(plane, points)) std::replace(planes_.of_point.begin(), planes_.of_point.end(), plane, 0u);
      planes_.planes[plane - 1].points -= points;
    }
    RoofPlane plane;
    plane.c = mean_height(top);
    plane.lowest = plane.highest = site_.points[top[0]].z;
    const auto label = static_cast<std::uint32_t>(planes_.planes.size() + 1);
    for (const std::uint32_t i : top) {
      if (std::abs(site_.points[i].z - plane.c) > planes_.epsilon) continue;
      planes_.of_point[i] = label;
      free_[i] = 0;
      ++plane.points;
      plane.lowest = std::min(plane.lowest, site_.points[i].z);
      plane.highest = std::max(plane.highest, site_.points[i].z);
    }
    planes_.planes.push_back(plane);
  }

  const RoofSite& site_;
  RoofPlanes& planes_;
  std::vector<std::uint8_t> tried_ = std::vector<std::uint8_t>(site_.points.size(), 0);
  std::vector<std::uint32_t> grown_ = std::vector<std::uint32_t>(site_.points.size(), 0);  // last growth with the point
  std::uint32_t growth_ = 0;
  double reach_ = kTopReachSteps.front() * planes_.step;
  std::vector<Point2> places_;
  Rows all_;
  std::set<std::uint32_t> no_surface_;  // planes
  std::vector<std::uint8_t> free_;      // per point: it may belong to a top
  std::optional<Rows> rows_;            // rows of the points that were free at the beginning
  Indices first_, others_;              // per free point its neighbours; empty where there are too many to store
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
