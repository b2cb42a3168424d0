// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/site_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

constexpr double kMetresPerStep = 0.001;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

SiteFilter::EdgeSet::EdgeSet(const SitePolygon& polygon) {
  for (const auto& ring : polygon) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
      edges.push_back({{a.x * kMetresPerStep, a.y * kMetresPerStep}, {b.x * kMetresPerStep, b.y * kMetresPerStep}});
      box.add(edges.back().a);
      box.add(edges.back().b);
    }
  }
}

bool SiteFilter::EdgeSet::near(Vec3 p, double reach) const {
  return box.grown(reach).contains(FlatPoint{p.x, p.y});
}

bool SiteFilter::EdgeSet::contains(Vec3 p) const {
  if (!near(p, 0)) return false;
  bool inside = false;
  for (const FlatEdge& e : edges) inside ^= ray_crosses({p.x, p.y}, e.a, e.b);
  return inside;
}

// The squared distance to the nearest edge; infinite when it is surely beyond reach.
double SiteFilter::EdgeSet::distance2(Vec3 p, double reach) const {
  if (!near(p, reach)) return kInfinity;
  double best = kInfinity;
  for (const FlatEdge& e : edges) best = std::min(best, squared_distance({p.x, p.y}, e));
  return best;
}

SiteFilter::SiteFilter(std::span<const SitePolygon> outlines, std::size_t own, const SitePointsParams& params)
    : own_(own), params_(params) {
  for (const SitePolygon& outline : outlines) sets_.emplace_back(outline);
}

PointMembership SiteFilter::of(Vec3 p, PointRole role) const {
  if (sets_[own_].contains(p)) return PointMembership::held;
  const bool ground = role == PointRole::ground;
  const double reach = ground ? params_.ground_reach : params_.margin;
  const double d2 = sets_[own_].distance2(p, reach);
  if (d2 > reach * reach) return PointMembership::none;
  for (const EdgeSet& set : sets_)
    if (set.contains(p)) return PointMembership::none;
  if (ground) return PointMembership::ground;
  return is_nearest(p, d2) ? PointMembership::held : PointMembership::none;
}

double SiteFilter::distance(Vec3 p, double reach) const {
  return std::sqrt(sets_[own_].distance2(p, reach));
}

bool SiteFilter::at_edge(Vec3 p) const {
  return sets_[own_].distance2(p, params_.margin) <= params_.margin * params_.margin;
}

bool SiteFilter::is_nearest(Vec3 p, double d2) const {
  for (std::size_t n = 0; n < sets_.size(); ++n) {
    const double other = n == own_ ? kInfinity : sets_[n].distance2(p, params_.margin);
    if (n < own_ ? other <= d2 : other < d2) return false;
  }
  return true;
}

void SiteMeasure::add(Vec3 p, PointRole role, PointMembership membership) {
  if (membership == PointMembership::ground) return ground_.add(p.z);
  if (membership == PointMembership::none) return;
  any_building_ |= role == PointRole::building;
  lowest_ = std::min(lowest_, p.z);
  if (p.z < lowest_at_edge_ && filter_.at_edge(p)) lowest_at_edge_ = p.z;
}

SiteRule SiteMeasure::rule() {
  SiteRule rule;
  rule.by_class = any_building_;
  if (ground_.count() > 0) {
    const SitePointsParams& params = filter_.params();
    const double last = static_cast<double>(ground_.count() - 1);
    rule.ground = ground_.nth(static_cast<std::uint64_t>(params.ground_share * last));
    if (!rule.by_class) rule.lowest = rule.ground + params.clearance;
    return rule;
  }
  rule.ground_source = GroundSource::lowest_point;
  rule.ground = lowest_at_edge_ < kInfinity ? lowest_at_edge_ : lowest_ < kInfinity ? lowest_ : 0;
  return rule;
}

SitePoints choose_points(const Surroundings& around, std::span<const SitePolygon> outlines, std::size_t own,
                         const SitePointsParams& params) {
  const SiteFilter filter(outlines, own, params);
  SiteMeasure measure(filter);
  std::vector<std::uint32_t> held;
  for (std::uint32_t i = 0; i < around.points.size(); ++i) {
    const PointMembership membership = filter.of(around.points[i], around.roles[i]);
    measure.add(around.points[i], around.roles[i], membership);
    if (membership == PointMembership::held) held.push_back(i);
  }
  SitePoints site{{}, measure.rule()};
  for (const std::uint32_t i : held)
    if (site.rule.takes(around.roles[i], around.points[i].z)) site.building.push_back(i);
  return site;
}

}  // namespace ilot
