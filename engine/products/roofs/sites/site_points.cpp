// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/site_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

constexpr double kMetresPerStep = 0.001;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

SiteFilter::SiteFilter(const SitePolygon& outline, const SitePointsParams& params) : params_(params) {
  for (const auto& ring : outline) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
      edges_.push_back({{a.x * kMetresPerStep, a.y * kMetresPerStep}, {b.x * kMetresPerStep, b.y * kMetresPerStep}});
      box_.add(edges_.back().a);
      box_.add(edges_.back().b);
    }
  }
}

bool SiteFilter::near(Vec3 p, double reach) const {
  return box_.grown(reach).contains(FlatPoint{p.x, p.y});
}

bool SiteFilter::contains(Vec3 p) const {
  if (!near(p, 0)) return false;
  bool inside = false;
  for (const FlatEdge& e : edges_) inside ^= ray_crosses({p.x, p.y}, e.a, e.b);
  return inside;
}

// The squared distance to the nearest edge; infinite when it is surely beyond reach.
double SiteFilter::distance2(Vec3 p, double reach) const {
  if (!near(p, reach)) return kInfinity;
  double best = kInfinity;
  for (const FlatEdge& e : edges_) best = std::min(best, squared_distance({p.x, p.y}, e));
  return best;
}

PointMembership SiteFilter::of(Vec3 p, PointRole role) const {
  if (contains(p)) return PointMembership::held;
  const bool ground = role == PointRole::ground;
  const double reach = ground ? params_.ground_reach : params_.margin;
  if (distance2(p, reach) > reach * reach) return PointMembership::none;
  return ground ? PointMembership::ground : PointMembership::beside;
}

double SiteFilter::distance(Vec3 p, double reach) const {
  return std::sqrt(distance2(p, reach));
}

bool SiteFilter::at_edge(Vec3 p) const {
  return distance2(p, params_.margin) <= params_.margin * params_.margin;
}

std::uint8_t SiteFilter::away(Vec3 p) const {
  if (contains(p)) return 0;
  const double d = distance(p, params_.margin);
  return d < params_.margin ? static_cast<std::uint8_t>(1 + std::floor(254 * d / params_.margin)) : 255;
}

void SiteMeasure::add(Vec3 p, PointRole role, PointMembership membership) {
  if (membership == PointMembership::ground) return ground_.add(p.z);
  if (membership == PointMembership::none) return;
  const bool at_edge = membership == PointMembership::beside || (p.z < lowest_at_edge_ && filter_.at_edge(p));
  if (at_edge) lowest_at_edge_ = std::min(lowest_at_edge_, p.z);
  if (membership == PointMembership::beside) return;
  any_building_ |= role == PointRole::building;
  lowest_ = std::min(lowest_, p.z);
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
  const double lowest = lowest_at_edge_ < kInfinity ? lowest_at_edge_ : lowest_;
  rule.ground_source = lowest < kInfinity ? GroundSource::lowest_point : GroundSource::none;
  if (lowest < kInfinity) rule.ground = lowest;
  return rule;
}

SitePoints choose_points(const Surroundings& around, const SitePolygon& outline, const SitePointsParams& params) {
  const SiteFilter filter(outline, params);
  SiteMeasure measure(filter);
  SitePoints in_reach;
  for (std::uint32_t i = 0; i < around.points.size(); ++i) {
    const PointMembership membership = filter.of(around.points[i], around.roles[i]);
    measure.add(around.points[i], around.roles[i], membership);
    if (membership == PointMembership::held) in_reach.building.push_back(i);
    if (membership == PointMembership::beside) in_reach.beside.push_back(i);
  }
  SitePoints site{{}, {}, measure.rule()};
  const auto taken = [&](std::uint32_t i) { return site.rule.takes(around.roles[i], around.points[i].z); };
  std::ranges::copy_if(in_reach.building, std::back_inserter(site.building), taken);
  std::ranges::copy_if(in_reach.beside, std::back_inserter(site.beside), taken);
  return site;
}

}  // namespace ilot
