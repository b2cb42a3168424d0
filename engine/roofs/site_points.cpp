// SPDX-License-Identifier: Apache-2.0
#include "engine/roofs/site_points.h"

#include <algorithm>
#include <limits>

namespace ilot {
namespace {

constexpr double kMillimetre = 0.001;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// In metres. From the lower end to the upper one, so that neighbours see a common edge with the same bits.
struct Edge {
  double x0, y0, x1, y1;
};

struct EdgeSet {
  std::vector<Edge> edges;
  double min_x = kInfinity, min_y = kInfinity, max_x = -kInfinity, max_y = -kInfinity;

  explicit EdgeSet(const SitePolygon& polygon) {
    for (const auto& ring : polygon) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
        if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
        edges.push_back({a.x * kMillimetre, a.y * kMillimetre, b.x * kMillimetre, b.y * kMillimetre});
        min_x = std::min({min_x, edges.back().x0, edges.back().x1});
        max_x = std::max({max_x, edges.back().x0, edges.back().x1});
        min_y = std::min(min_y, edges.back().y0);
        max_y = std::max(max_y, edges.back().y1);
      }
    }
  }

  bool near(Vec3 p, double reach) const {
    return p.x >= min_x - reach && p.x <= max_x + reach && p.y >= min_y - reach && p.y <= max_y + reach;
  }

  bool holds(Vec3 p) const {
    if (!near(p, 0)) return false;
    bool inside = false;
    for (const Edge& e : edges)
      if (e.y0 <= p.y && p.y < e.y1)
        inside ^= (e.x1 - e.x0) * (p.y - e.y0) > (p.x - e.x0) * (e.y1 - e.y0);  // the edge passes on the right
    return inside;
  }

  // Squared distance to the nearest edge; infinite when it is surely beyond reach.
  double distance2(Vec3 p, double reach) const {
    if (!near(p, reach)) return kInfinity;
    double best = kInfinity;
    for (const Edge& e : edges) {
      const double ex = e.x1 - e.x0, ey = e.y1 - e.y0, px = p.x - e.x0, py = p.y - e.y0;
      const double along = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
      const double dx = px - along * ex, dy = py - along * ey;
      best = std::min(best, dx * dx + dy * dy);
    }
    return best;
  }
};

class Chooser {
 public:
  Chooser(const Surroundings& around, std::span<const SitePolygon> outlines, std::size_t own,
          const SitePointsParams& params)
      : around_(around), own_(own), params_(params) {
    for (const SitePolygon& outline : outlines) sets_.emplace_back(outline);
    for (std::uint32_t i = 0; i < around.points.size(); ++i) look_at(i);
  }

  SitePoints choose() {
    SitePoints site;
    find_ground(site);
    const auto is = [&](PointRole role) { return [this, role](std::uint32_t i) { return around_.roles[i] == role; }; };
    site.by_class = std::any_of(held_.begin(), held_.end(), is(PointRole::building));
    const PointRole wanted = site.by_class ? PointRole::building : PointRole::unclassified;
    const bool above_ground = !site.by_class && !ground_.empty();
    for (const std::uint32_t i : held_) {
      if (around_.roles[i] != wanted) continue;
      if (above_ground && around_.points[i].z < site.ground + params_.clearance) continue;
      site.building.push_back(i);
    }
    return site;
  }

 private:
  void look_at(std::uint32_t i) {
    const Vec3 p = around_.points[i];
    if (sets_[own_].holds(p)) return hold(i, p);
    const bool ground = around_.roles[i] == PointRole::ground;
    const double reach = ground ? params_.ground_reach : params_.margin;
    const double d2 = sets_[own_].distance2(p, reach);
    if (d2 > reach * reach) return;
    for (const EdgeSet& set : sets_)
      if (set.holds(p)) return;
    if (ground) return ground_.push_back(p.z);
    if (is_nearest(p, d2)) hold(i, p);
  }

  void hold(std::uint32_t i, Vec3 p) {
    held_.push_back(i);
    lowest_ = std::min(lowest_, p.z);
    const double m = params_.margin;
    if (p.z < lowest_at_edge_ && sets_[own_].distance2(p, m) <= m * m) lowest_at_edge_ = p.z;
  }

  bool is_nearest(Vec3 p, double d2) const {
    for (std::size_t n = 0; n < sets_.size(); ++n) {
      const double other = n == own_ ? kInfinity : sets_[n].distance2(p, params_.margin);
      if (n < own_ ? other <= d2 : other < d2) return false;
    }
    return true;
  }

  void find_ground(SitePoints& site) {
    if (!ground_.empty()) {
      const auto at = static_cast<std::ptrdiff_t>(params_.ground_share * static_cast<double>(ground_.size() - 1));
      std::nth_element(ground_.begin(), ground_.begin() + at, ground_.end());
      site.ground = ground_[static_cast<std::size_t>(at)];
      return;
    }
    site.ground_source = GroundSource::lowest_point;
    site.ground = lowest_at_edge_ < kInfinity ? lowest_at_edge_ : lowest_ < kInfinity ? lowest_ : 0;
  }

  const Surroundings& around_;
  std::size_t own_;
  SitePointsParams params_;
  std::vector<EdgeSet> sets_;
  std::vector<std::uint32_t> held_;
  std::vector<double> ground_;
  double lowest_ = kInfinity, lowest_at_edge_ = kInfinity;
};

}  // namespace

std::array<PointRole, 256> point_roles(std::span<const int> building, std::span<const int> ground) {
  std::array<PointRole, 256> roles;
  roles.fill(PointRole::other);
  for (const int code : {0, 1, 12}) roles[static_cast<std::size_t>(code)] = PointRole::unclassified;
  for (const int code : ground) roles[static_cast<std::size_t>(code)] = PointRole::ground;
  for (const int code : building) roles[static_cast<std::size_t>(code)] = PointRole::building;
  return roles;
}

SitePoints choose_points(const Surroundings& around, std::span<const SitePolygon> outlines, std::size_t own,
                         const SitePointsParams& params) {
  return Chooser(around, outlines, own, params).choose();
}

}  // namespace ilot
