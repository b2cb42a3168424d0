// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/hough_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels/core/portable_math.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/refine.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr double kMaxBins = 4096;
constexpr int kRounds = 30;  // a peak knows the middle of a plane; each round reaches farther

struct Extent {
  Vec3 min{INFINITY, INFINITY, INFINITY}, max{-INFINITY, -INFINITY, -INFINITY};
  void add(Vec3 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
};

class Transform {
 public:
  Transform(const OrientedPoints& points, const HoughPlanesParams& params)
      : points_(points), params_(params), directions_(equal_angle_directions(params.degrees)) {
    Extent box;
    for (std::size_t i = 0; i < points.points.size; ++i) box.add(position(i));
    centre_ = 0.5 * (box.min + box.max);
    reach_ = 0.5 * norm(box.max - box.min) + 1;
    step_ = std::max({1.0, params.distance_step, 2 * reach_ / kMaxBins});
    bins_ = static_cast<std::size_t>(2 * reach_ / step_) + 1;
    votes_.assign(directions_.size() * bins_, 0);
    result_.label.assign(points.points.size, 0);
  }

  PlaneSegments run() {
    Indices all(points_.points.size);
    std::iota(all.begin(), all.end(), 0u);
    vote(all, 1);
    const std::uint32_t least = std::max(3u, params_.min_points / 4);
    for (;;) {
      const auto peak = std::max_element(votes_.begin(), votes_.end());  // the first of equals
      if (*peak < least) break;
      const auto cell = static_cast<std::size_t>(peak - votes_.begin());
      const Indices members = plane_at(cell);
      if (members.empty()) {
        *peak = 0;  // votes of later taken points may wrap it; see vote()
        dead_.push_back(cell);
        continue;
      }
      for (const std::uint32_t i : members) result_.label[i] = static_cast<std::uint32_t>(result_.planes.size());
      vote(members, static_cast<std::uint32_t>(-1));
      for (const std::size_t d : dead_) votes_[d] = 0;
    }
    return std::move(result_);
  }

 private:
  Vec3 position(std::size_t i) const { return {points_.points.x[i], points_.points.y[i], points_.points.z[i]}; }
  bool has_normal(std::size_t i) const {
    return points_.nx != nullptr && (points_.nx[i] != 0 || points_.ny[i] != 0 || points_.nz[i] != 0);
  }
  std::size_t bin(const Vec3& direction, Vec3 from_centre) const {
    return static_cast<std::size_t>((dot(direction, from_centre) + reach_) / step_);
  }
  bool votes_for(std::size_t i, const Vec3& direction) const {
    if (params_.min_vote_cos <= 0) return true;
    if (!has_normal(i)) return false;
    return std::abs(dot(direction, {points_.nx[i], points_.ny[i], points_.nz[i]})) >= params_.min_vote_cos;
  }

  // Direction by direction, so that the row of the accumulator stays in the cache.
  void vote(const Indices& voters, std::uint32_t by) {
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      std::uint32_t* row = votes_.data() + d * bins_;
      const Vec3 direction = directions_[d];
      for (const std::uint32_t i : voters)
        if (votes_for(i, direction)) row[bin(direction, position(i) - centre_)] += by;
    }
  }

  Indices largest_part(const Indices& members) const {
    const Clusters clusters = euclidean_clusters(points_.points, members, params_.connectivity);
    Indices size(clusters.count, 0);
    for (const std::uint32_t c : clusters.id) ++size[c];
    if (size.empty()) return {};
    const auto chosen = static_cast<std::uint32_t>(std::max_element(size.begin(), size.end()) - size.begin());
    Indices part;
    for (std::size_t i = 0; i < members.size(); ++i)
      if (clusters.id[i] == chosen) part.push_back(members[i]);
    return part;
  }

  // The plane that a cell's voters start; empty when it has too few points.
  Indices plane_at(std::size_t cell) {
    const Vec3 direction = directions_[cell / bins_];
    Indices voters, free;
    for (std::uint32_t i = 0; i < points_.points.size; ++i) {
      if (result_.label[i] != 0) continue;
      free.push_back(i);
      if (votes_for(i, direction) && bin(direction, position(i) - centre_) == cell % bins_) voters.push_back(i);
    }
    const PlaneFit start = fit_plane(moments_of(points_.points, largest_part(voters)));
    if (!start.unique) return {};
    const RefineParams refine{params_.epsilon, params_.min_cos, 3, kRounds};
    RefinedPlane r = refine_plane(points_, free, start.plane, refine);
    Indices members = largest_part(r.members);
    const PlaneFit again = fit_plane(moments_of(points_.points, members));
    if (again.unique && members.size() < r.members.size()) {  // without the parts that do not belong to it
      r = refine_plane(points_, members, again.plane, refine);
      members = largest_part(r.members);
    }
    if (members.size() < params_.min_points) return {};
    result_.planes.push_back(r.plane);
    return members;
  }

  OrientedPoints points_;
  HoughPlanesParams params_;
  std::vector<Vec3> directions_;
  Vec3 centre_;
  double reach_ = 0, step_ = 1;
  std::size_t bins_ = 0;
  Indices votes_;                  // directions x bins
  std::vector<std::size_t> dead_;  // cells that gave no plane
  PlaneSegments result_;
};

}  // namespace

std::vector<Vec3> equal_angle_directions(double degrees) {
  const double edge = degrees / kDegreesPerRadian;
  const auto bands = static_cast<std::size_t>(std::ceil(90 / degrees));
  std::vector<std::size_t> cells(bands);
  std::size_t total = 0;
  for (std::size_t b = 0; b < bands; ++b) {
    const double middle = 90 * (static_cast<double>(b) + 0.5) / static_cast<double>(bands);
    constexpr double kTurn = 6.283185307179586;
    cells[b] = std::max<std::size_t>(1, static_cast<std::size_t>(std::nearbyint(kTurn * cos_degrees(middle) / edge)));
    total += cells[b];
  }
  std::vector<Vec3> directions;
  std::size_t below = 0;
  for (std::size_t b = 0; b < bands; ++b) {
    // A band's share of the height is its share of the area (Archimedes).
    const double z = (static_cast<double>(below) + 0.5 * static_cast<double>(cells[b])) / static_cast<double>(total);
    const double across = std::sqrt(1 - z * z);
    for (std::size_t j = 0; j < cells[b]; ++j) {
      const double theta = 360 * (static_cast<double>(j) + 0.5) / static_cast<double>(cells[b]);
      directions.push_back({across * cos_degrees(theta), across * cos_degrees(theta - 90), z});
    }
    below += cells[b];
  }
  return directions;
}

PlaneSegments hough_planes(const OrientedPoints& points, const HoughPlanesParams& params) {
  if (points.points.size == 0) return {};
  return Transform(points, params).run();
}

}  // namespace ilot
