// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/face_rectangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace ilot {
namespace {

// Choice: dormers and sheds; larger faces get their own outline.
constexpr double kSmallFace = 10;  // m2 that the points of a plane stand for
// Derived: a triangle fills half of its box, a rectangle all of it.
constexpr double kFilled = 0.65;  // of the rectangle, by its points plus one deviation; triangles have less
// Choice: 2 % of the area, less than a step along one side of a dormer.
constexpr double kClearlySmaller = 0.98;  // a less likely direction must reduce the area to this share
// Choice: the error of an edge of airborne scans is a step, 0.3 m; nearer sides are one line.
constexpr double kAligned = 0.1;  // metres between a side and the line onto which it is moved
// Derived: two steps contain one row of points.
constexpr double kSideReachSteps = 2;  // steps beyond a side; points of others matter within this distance
// Derived: 17 degrees: at less, noise of 5 cm moves the meeting line by more than a step.
constexpr double kLeastRise = 0.3;  // least slope between two planes that end in their meeting line
// Derived: ten steps of the grid of 1 mm.
constexpr double kBeyond = 0.01;  // metres past the corners, so that rounding leaves no gap

// The sides across `along` (u) and along it (v), the low one of each pair first.
struct Rectangle {
  FlatPoint along;
  std::array<double, 2> u{INFINITY, -INFINITY}, v{INFINITY, -INFINITY};
  double area() const { return (u[1] - u[0]) * (v[1] - v[0]); }
  FlatPoint at(double s, double t) const { return {s * along.x - t * along.y, s * along.y + t * along.x}; }
};

Rectangle around(const std::vector<FlatPoint>& points, FlatPoint along) {
  Rectangle r;
  r.along = along;
  for (const FlatPoint p : points) {
    r.u = {std::min(r.u[0], dot(along, p)), std::max(r.u[1], dot(along, p))};
    r.v = {std::min(r.v[0], cross(along, p)), std::max(r.v[1], cross(along, p))};
  }
  return r;
}

class Drawer {
 public:
  Drawer(const RoofSite& site, const RoofPlanes& planes, std::span<const FlatPoint> directions,
         std::span<const FlatEdge> lines)
      : site_(site), planes_(planes), directions_(directions), lines_(lines), members_(planes.planes.size()) {
    for (std::uint32_t i = 0; i < site.points.size(); ++i) {
      if (planes.of_point[i] == 0) continue;
      by_x_.push_back(i);
      if (small(planes.of_point[i])) members_[planes.of_point[i] - 1].push_back({site.points[i].x, site.points[i].y});
    }
    std::sort(by_x_.begin(), by_x_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(site.points[a].x, a) < std::pair(site.points[b].x, b);
    });
  }

  std::vector<FlatEdge> draw() {
    for (std::uint32_t plane = 1; plane <= members_.size(); ++plane)
      if (!members_[plane - 1].empty()) add(plane);
    return std::move(sides_);
  }

 private:
  bool small(std::uint32_t plane) const {
    return planes_.planes[plane - 1].points * planes_.step * planes_.step < kSmallFace;
  }

  void add(std::uint32_t plane) {
    const std::vector<FlatPoint>& points = members_[plane - 1];
    Rectangle best;
    double least = INFINITY;
    for (const FlatPoint d : directions_) {
      Rectangle r = around(points, d);
      const double half = planes_.step / 2;
      const double area = (r.u[1] - r.u[0] + 2 * half) * (r.v[1] - r.v[0] + 2 * half);
      if (area >= least * kClearlySmaller) continue;
      least = area;
      best = r;
    }
    const auto count = static_cast<double>(points.size());
    if ((count + std::sqrt(count)) * planes_.step * planes_.step < kFilled * least) return;
    best = placed(best, plane);
    for (const double v : best.v) sides_.push_back({best.at(best.u[0] - kBeyond, v), best.at(best.u[1] + kBeyond, v)});
    for (const double u : best.u) sides_.push_back({best.at(u, best.v[0] - kBeyond), best.at(u, best.v[1] + kBeyond)});
  }

  // The surroundings beyond one side of a box of points: how far away they are, and whether they are higher.
  struct Beyond {
    double gap = INFINITY;
    bool higher = false;
  };
  struct Surroundings {
    std::array<Beyond, 2> u, v;
    std::set<std::uint32_t> planes;
  };

  Rectangle placed(const Rectangle& box, std::uint32_t plane) const {
    const double reach = kSideReachSteps * planes_.step;
    const Surroundings seen = look_around(box, plane, reach);
    Rectangle r = box;
    const FlatPoint across{-box.along.y, box.along.x};
    const double width = box.u[1] - box.u[0], depth = box.v[1] - box.v[0];
    for (const std::size_t end : {0u, 1u}) {
      const double out = end == 0 ? -1 : 1;
      const auto at_u = meeting(plane, seen.planes, {box.at(box.u[end], box.v[0]), box.at(box.u[end], box.v[1])},
                                {out * box.along.x, out * box.along.y}, seen.u[end].gap);
      const auto at_v = meeting(plane, seen.planes, {box.at(box.u[0], box.v[end]), box.at(box.u[1], box.v[end])},
                                {out * across.x, out * across.y}, seen.v[end].gap);
      r.u[end] += out * at_u.value_or(margin(seen.u[end], depth, reach));
      r.v[end] += out * at_v.value_or(margin(seen.v[end], width, reach));
    }
    if (r.u[0] >= r.u[1] || r.v[0] >= r.v[1]) r = box;
    for (const FlatEdge& line : lines_) align(line, r);
    return r;
  }

  // How far a side lies beyond its outermost point.
  double margin(const Beyond& beyond, double length, double reach) const {
    const double spacing = std::min(planes_.step / 2, planes_.step * planes_.step / std::max(length, planes_.step));
    if (beyond.gap > reach) return spacing;
    const double share = std::min(beyond.gap / 2, spacing);
    return beyond.higher ? beyond.gap - share : share;
  }

  // How far beyond a side the plane meets another plane that rises outwards, parallel to the side.
  std::optional<double> meeting(std::uint32_t plane, const std::set<std::uint32_t>& others, FlatEdge side,
                                FlatPoint outwards, double gap) const {
    const RoofPlane& own = planes_.planes[plane - 1];
    std::optional<double> nearest;
    for (const std::uint32_t number : others) {
      const RoofPlane& other = planes_.planes[number - 1];
      const double rise = (other.gx - own.gx) * outwards.x + (other.gy - own.gy) * outwards.y;
      if (rise < kLeastRise) continue;
      const double a = (own.at(side.a.x, side.a.y) - other.at(side.a.x, side.a.y)) / rise;
      const double b = (own.at(side.b.x, side.b.y) - other.at(side.b.x, side.b.y)) / rise;
      const double at = (a + b) / 2;
      if (std::abs(a - b) > 2 * kAligned || at < -planes_.step || at > std::min(gap, planes_.step)) continue;
      if (!nearest || at < *nearest) nearest = at;
    }
    return nearest;
  }

  Surroundings look_around(const Rectangle& box, std::uint32_t plane, double reach) const {
    Surroundings seen;
    double low_x = INFINITY, high_x = -INFINITY;
    for (const double s : box.u)
      for (const double t : box.v) {
        low_x = std::min(low_x, box.at(s, t).x);
        high_x = std::max(high_x, box.at(s, t).x);
      }
    auto at = std::lower_bound(by_x_.begin(), by_x_.end(), low_x - reach,
                               [&](std::uint32_t i, double x) { return site_.points[i].x < x; });
    for (; at != by_x_.end() && site_.points[*at].x <= high_x + reach; ++at) {
      if (planes_.of_point[*at] == plane) continue;
      const Vec3 p = site_.points[*at];
      const double s = dot(box.along, {p.x, p.y}), t = cross(box.along, {p.x, p.y});
      const bool higher = p.z > planes_.planes[plane - 1].at(p.x, p.y);
      if (t > box.v[0] && t < box.v[1]) note(s, box.u, higher, seen.u);
      if (s > box.u[0] && s < box.u[1]) note(t, box.v, higher, seen.v);
      if (s > box.u[0] - reach && s < box.u[1] + reach && t > box.v[0] - reach && t < box.v[1] + reach)
        seen.planes.insert(planes_.of_point[*at]);
    }
    return seen;
  }

  static void note(double s, const std::array<double, 2>& ends, bool higher, std::array<Beyond, 2>& sides) {
    if (s < ends[0] && ends[0] - s < sides[0].gap) sides[0] = {ends[0] - s, higher};
    if (s > ends[1] && s - ends[1] < sides[1].gap) sides[1] = {s - ends[1], higher};
  }

  // Moves sides along which the line runs onto the line.
  static void align(const FlatEdge& line, Rectangle& r) {
    const FlatPoint d{line.b.x - line.a.x, line.b.y - line.a.y};
    const double length = std::sqrt(dot(d, d));
    if (length <= 0) return;
    const auto seen = [&](FlatPoint p) {  // along the line and across it
      const FlatPoint from{p.x - line.a.x, p.y - line.a.y};
      return FlatPoint{dot(d, from) / length, cross(d, from) / length};
    };
    const auto shift = [&](FlatPoint from, FlatPoint to, FlatPoint outwards) {
      const FlatPoint a = seen(from), b = seen(to);
      const double turn = cross(d, outwards) / length;
      if (std::max(std::abs(a.y), std::abs(b.y)) > kAligned || std::abs(turn) < 0.5) return 0.0;
      if (std::max(a.x, b.x) < 0 || std::min(a.x, b.x) > length) return 0.0;
      return -(a.y + b.y) / 2 / turn;
    };
    for (double& u : r.u) u += shift(r.at(u, r.v[0]), r.at(u, r.v[1]), r.along);
    for (double& v : r.v) v += shift(r.at(r.u[0], v), r.at(r.u[1], v), {-r.along.y, r.along.x});
  }

  const RoofSite& site_;
  const RoofPlanes& planes_;
  std::span<const FlatPoint> directions_;
  std::span<const FlatEdge> lines_;
  std::vector<std::vector<FlatPoint>> members_;  // per plane, only for small planes
  std::vector<std::uint32_t> by_x_;              // points with a plane
  std::vector<FlatEdge> sides_;
};

}  // namespace

std::vector<FlatEdge> face_rectangles(const RoofSite& site, const RoofPlanes& planes,
                                      std::span<const FlatPoint> directions, std::span<const FlatEdge> lines) {
  return Drawer(site, planes, directions, lines).draw();
}

}  // namespace ilot
