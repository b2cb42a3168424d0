// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/plane_joining.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "kernels/core/eigen3.h"
#include "kernels/core/moments.h"

namespace ilot {
namespace {

// Derived: the points are in millimetres.
constexpr double kUnitsPerMetre = 1000;
// Choice: one point in ten may be a neighbour's, at a border that nobody knows better.
constexpr double kExplained = 0.9;  // share of a plane's points within `detail` of the joint plane
// Derived: a plane with nine tenths of its points within `detail` and the others within epsilon of its own plane.
constexpr double kClearlyApart = 1.5;  // times `detail`: root mean square distance from which no points are examined
// Choice: two lost points in a row, and a metre, the width of a parapet with its gutter.
constexpr double kNearSteps = 3, kNearMetres = 1;  // cells in which planes are near each other

// Choice: flat roofs sag and fall by 2 to 3 degrees and are drawn as one face; a crease between slopes is seen.
constexpr double kFlat = 0.9962;  // cosine of 5 degrees
// Choice: a crease of 8 cm between slopes is above the noise of airborne scans; flatter ones are lost.
constexpr double kOfClearPlanes = 0.5;  // share of `detail` that holds for pairs with a sloping plane
// Derived: the standard deviation across a strip of a metre is a metre over the root of 12.
constexpr double kNarrow = 289;  // units; the slope of a narrower plane is not known

using Pair = std::pair<std::uint32_t, std::uint32_t>;  // groups, the smaller first

class Joiner {
 public:
  Joiner(Points points, double detail, const RoofPlanes& planes)
      : points_(points), detail_(detail * kUnitsPerMetre), members_(planes.planes.size()) {
    for (std::uint32_t i = 0; i < planes.of_point.size(); ++i)
      if (planes.of_point[i] != 0) members_[planes.of_point[i] - 1].push_back(i);
    for (std::uint32_t g = 0; g < members_.size(); ++g) {
      moments_.push_back(moments_of(points_, members_[g]));
      parts_.push_back({g});
      planes_.emplace_back();
      shapes_.push_back(shape_of(moments_.back()));
    }
    find_near(std::max(kNearSteps * planes.step, kNearMetres) * kUnitsPerMetre);
  }

  // Returns for each given plane the group to which it belongs now, itself where it was not joined.
  std::vector<std::uint32_t> join() {
    for (const Pair& pair : near_) examine(pair);
    while (!candidates_.empty()) {
      const auto [rms, pair] = *candidates_.begin();
      unite(pair);
    }
    std::vector<std::uint32_t> group(members_.size());
    for (std::uint32_t g = 0; g < parts_.size(); ++g)
      for (const std::uint32_t part : parts_[g]) group[part] = g;
    return group;
  }

  // The plane of a group of several planes.
  const std::optional<Plane>& plane(std::uint32_t group) const { return planes_[group]; }

 private:
  // Planes with points in one cell or in cells that touch are near each other.
  void find_near(double cell) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::set<std::uint32_t>> cells;
    for (std::uint32_t g = 0; g < members_.size(); ++g)
      for (const std::uint32_t i : members_[g])
        cells[{static_cast<std::int64_t>(std::floor(points_.x[i] / cell)),
               static_cast<std::int64_t>(std::floor(points_.y[i] / cell))}]
            .insert(g);
    for (const auto& [at, groups] : cells)
      for (std::int64_t dx = 0; dx <= 1; ++dx)
        for (std::int64_t dy = dx == 0 ? 0 : -1; dy <= 1; ++dy) {
          const auto other = cells.find({at.first + dx, at.second + dy});
          if (other == cells.end()) continue;
          for (const std::uint32_t g : groups)
            for (const std::uint32_t h : other->second)
              if (g != h) near_.insert(std::minmax(g, h));
        }
  }

  void examine(const Pair& pair) {
    const auto [g, h] = pair;
    Moments both = moments_[g];
    both.add(moments_[h]);
    const PlaneFit fit = fit_plane(both);
    const Shape &a = shapes_[g], &b = shapes_[h];
    if (!fit.unique || std::abs(fit.plane.n.z) < std::min(a.upright, b.upright)) return;
    const bool clear = !a.narrow && !b.narrow && !(a.level && b.level);
    const double reach = clear ? kOfClearPlanes * detail_ : detail_;
    const double apart = kClearlyApart * reach;
    if (rms_to_plane(moments_[g], fit.plane) > apart || rms_to_plane(moments_[h], fit.plane) > apart) return;
    for (const std::uint32_t group : {g, h})
      for (const std::uint32_t part : parts_[group])
        if (!explains(fit.plane, members_[part], reach)) return;
    candidates_.insert({fit.rms, pair});
    fits_[pair] = {fit.rms, fit.plane};
  }

  struct Shape {
    double upright = 0;  // z of the plane's unit normal; two narrow planes are not joined by a steeper one
    bool level = false, narrow = false;
  };
  static Shape shape_of(const Moments& moments) {
    const Eigen3 axes = eigen_symmetric(covariance(moments));
    return {std::abs(fit_plane(moments).plane.n.z), std::abs(axes.vectors[0].z) > kFlat,
            axes.values[1] < kNarrow * kNarrow};
  }

  bool explains(const Plane& plane, std::span<const std::uint32_t> points, double reach) const {
    std::size_t within = 0;
    for (const std::uint32_t i : points)
      within += std::abs(signed_distance(plane, {points_.x[i], points_.y[i], points_.z[i]})) <= reach;
    return static_cast<double>(within) >= kExplained * static_cast<double>(points.size());
  }

  void unite(const Pair& pair) {
    const auto [g, h] = pair;
    planes_[g] = fits_.at(pair).second;
    moments_[g].add(moments_[h]);
    shapes_[g] = shape_of(moments_[g]);
    parts_[g].insert(parts_[g].end(), parts_[h].begin(), parts_[h].end());
    parts_[h].clear();
    std::set<std::uint32_t> around;
    for (auto at = near_.begin(); at != near_.end();) {
      const bool of_g = at->first == g || at->second == g, of_h = at->first == h || at->second == h;
      if (!of_g && !of_h) {
        ++at;
        continue;
      }
      for (const std::uint32_t other : {at->first, at->second})
        if (other != g && other != h) around.insert(other);
      if (const auto fit = fits_.find(*at); fit != fits_.end()) {
        candidates_.erase({fit->second.first, *at});
        fits_.erase(fit);
      }
      at = near_.erase(at);
    }
    for (const std::uint32_t other : around) {
      near_.insert(std::minmax(g, other));
      examine(std::minmax(g, other));
    }
  }

  Points points_;
  double detail_;
  std::vector<std::vector<std::uint32_t>> members_, parts_;  // points of the given planes; given planes of each group
  std::vector<Moments> moments_;
  std::vector<Shape> shapes_;
  std::vector<std::optional<Plane>> planes_;
  std::set<Pair> near_;
  std::map<Pair, std::pair<double, Plane>> fits_;  // of the candidates
  std::set<std::pair<double, Pair>> candidates_;   // by their residuals
};

}  // namespace

RoofPlane roof_plane(const Plane& plane, Vec3 corner) {
  RoofPlane r;
  r.gx = -plane.n.x / plane.n.z;
  r.gy = -plane.n.y / plane.n.z;
  r.c = corner.z - plane.d / kUnitsPerMetre / plane.n.z - r.gx * corner.x - r.gy * corner.y;
  r.lowest = std::numeric_limits<double>::infinity();
  r.highest = -r.lowest;
  return r;
}

void join_explained(Points points, Vec3 corner, double detail, RoofPlanes& planes) {
  if (!(detail > 0) || planes.planes.size() < 2) return;
  Joiner joiner(points, detail, planes);
  const std::vector<std::uint32_t> group = joiner.join();
  std::vector<std::uint32_t> number(planes.planes.size() + 1, 0);
  std::vector<RoofPlane> kept;
  for (std::uint32_t p = 0; p < planes.planes.size(); ++p) {
    if (group[p] != p) continue;
    RoofPlane plane = planes.planes[p];
    if (joiner.plane(p)) {
      plane = roof_plane(*joiner.plane(p), corner);
      for (std::uint32_t q = 0; q < planes.planes.size(); ++q) {
        if (group[q] != p) continue;
        plane.points += planes.planes[q].points;
        plane.lowest = std::min(plane.lowest, planes.planes[q].lowest);
        plane.highest = std::max(plane.highest, planes.planes[q].highest);
      }
    }
    kept.push_back(plane);
    number[p + 1] = static_cast<std::uint32_t>(kept.size());
  }
  if (kept.size() == planes.planes.size()) return;
  for (std::uint32_t p = 0; p < planes.planes.size(); ++p) number[p + 1] = number[group[p] + 1];
  for (std::uint32_t& label : planes.of_point) label = number[label];
  planes.planes = std::move(kept);
  planes.epsilon = std::max(planes.epsilon, detail);
}

}  // namespace ilot
