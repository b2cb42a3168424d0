// SPDX-License-Identifier: Apache-2.0
// Walls and dormers as engine/products/facades/walls/wall_groups.h finds them. Here every wall is compared with all
// segments: this is slow and easy to read.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "engine/products/facades/walls/segment_grid.h"
#include "engine/products/facades/walls/wall_groups.h"
#include "kernels/core/portable_math.h"

namespace ilot::test::plain_walls {

constexpr double kParallelDeg = 5;  // greatest angle between a plane of a facade's relief and its wall
constexpr double kCoplanarDeg = 2;  // greatest angle between parts of one wall
constexpr double kLargePart = 1;    // m2; smaller pieces beside the wall's plane are relief
constexpr double kInside = 0.5;     // share of the width of a plane that must be along the wall if it is its relief

using Extent = WallExtent;

inline FacadeAxes axes_of(const Segment& s, Vec3 out) {
  FacadeAxes axes;
  axes.out = out;
  axes.origin = s.centroid - signed_distance(s.plane, s.centroid) * s.plane.n;
  const Vec3 right = cross(Vec3{0, 0, 1}, out);
  axes.right = (1 / norm(right)) * right;
  axes.up = cross(axes.out, axes.right);
  return axes;
}

inline Vec3 street_side(const Segment& s, std::span<const Vec3> stations, Vec3 middle) {
  double vote = 0;
  for (const Vec3& station : stations) {
    const double off = signed_distance(s.plane, station), far = norm(station - s.centroid);
    if (off != 0 && far > 0) vote += (off > 0 ? 1 : -1) / (far * far);
  }
  if (vote == 0) vote = signed_distance(s.plane, middle) > 0 ? -1 : 1;
  return vote > 0 ? s.plane.n : -1.0 * s.plane.n;
}

// If there is no station, a storey that stands back faces in the same direction as the wall below it.
inline Vec3 side_like(const Segment& s, const std::vector<WallGroup>& walls, const WallParams& params, Vec3 otherwise) {
  for (const WallGroup& wall : walls) {
    const double off = dot(s.centroid - wall.axes.origin, wall.axes.out) * params.metres_per_unit;
    if (std::abs(dot(s.plane.n, wall.axes.out)) < cos_degrees(kParallelDeg) || std::abs(off) > params.relief_behind)
      continue;
    return dot(s.plane.n, wall.axes.out) > 0 ? s.plane.n : -1.0 * s.plane.n;
  }
  return otherwise;
}

inline void include(Extent& all, const Extent& e) {
  all.u0 = std::min(all.u0, e.u0);
  all.u1 = std::max(all.u1, e.u1);
  all.v0 = std::min(all.v0, e.v0);
  all.v1 = std::max(all.v1, e.v1);
}

// Adds segments that are in the plane of the wall and continue along it, until there are no more.
inline void join_coplanar(std::span<const Segment> segments, const std::vector<std::size_t>& upright,
                          std::vector<char>& taken, const WallParams& params, WallGroup& group, Extent& all) {
  const double least_cos = cos_degrees(kCoplanarDeg);
  for (bool more = true; more;) {
    more = false;
    for (const std::size_t i : upright) {
      const Segment& s = segments[i];
      if (taken[i] != 0 || std::abs(dot(s.plane.n, group.axes.out)) < least_cos) continue;
      const Extent e = extent_of(s, group.axes, params.metres_per_unit);
      const double off = s.area_m2 < kLargePart ? std::min(params.bias, s.epsilon_m) : params.bias;
      if (std::abs(e.w0) > off || e.u0 > all.u1 + params.gap || e.u1 < all.u0 - params.gap ||
          e.v0 > all.v1 + params.gap || e.v1 < all.v0 - params.gap)
        continue;
      taken[i] = 1;
      include(all, e);
      group.segments.push_back(s.id);
      group.points += s.points;
      group.area_m2 += s.area_m2;
      group.epsilon = std::max(group.epsilon, s.epsilon_m);
      more = true;
    }
  }
}

// Returns a group of one segment.
inline WallGroup group_of(const Segment& s, Vec3 out) {
  WallGroup group;
  group.axes = axes_of(s, out);
  group.segments = {s.id};
  group.points = s.points;
  group.area_m2 = s.area_m2;
  group.epsilon = s.epsilon_m;
  group.rms = s.rms_m;
  return group;
}

inline void set_box(WallGroup& group, const Extent& all, double metres) {
  group.width = all.u1 - all.u0;
  group.height = all.v1 - all.v0;
  group.axes.origin = group.axes.origin + (all.u0 / metres) * group.axes.right + (all.v0 / metres) * group.axes.up;
}

// Returns the share of a front that another front covers, seen perpendicular to it.
inline double common_share(const WallGroup& front, const WallGroup& other, double metres) {
  const Vec3 d = metres * (front.axes.origin - other.axes.origin);
  const double u = dot(d, other.axes.right), v = dot(d, other.axes.up);
  const double across = std::min(u + front.width, other.width) - std::max(u, 0.0);
  const double up = std::min(v + front.height, other.height) - std::max(v, 0.0);
  return std::max(across, 0.0) * std::max(up, 0.0) / (front.width * front.height);
}

// Two storeys high, or a storey that stands back along half of the wall; 10 cm off.
inline bool is_wall_of_its_own(const Extent& e, const Segment& s, double wall_width, const WallParams& params) {
  const double width = e.u1 - e.u0, height = e.v1 - e.v0;
  if (std::abs(e.w0) <= 0.1 || width < params.least_width || s.area_m2 < params.least_area) return false;
  if (height >= 4) return s.area_m2 >= 0.5 * width * height;
  return e.w0 < 0 && height >= params.least_height && width >= 4 && width >= 0.5 * wall_width &&
         s.area_m2 >= 0.3 * width * height;
}

// Claims the segments that are parallel to the wall and along it, so that a balcony or a shop front does not become a
// facade of its own.
inline void claim_relief(std::span<const Segment> segments, const std::vector<std::size_t>& parallel_candidates,
                         std::vector<char>& taken, const WallParams& params, WallGroup& group) {
  const double least_cos = cos_degrees(kParallelDeg);
  for (const std::size_t i : parallel_candidates) {
    const Segment& s = segments[i];
    if (std::abs(dot(s.plane.n, group.axes.out)) < least_cos) continue;
    if (std::find(group.segments.begin(), group.segments.end(), s.id) != group.segments.end()) continue;
    const Extent e = extent_of(s, group.axes, params.metres_per_unit);
    const double common = std::min(e.u1, group.width) - std::max(e.u0, 0.0);
    if (e.w0 > params.relief_front || e.w0 < -params.relief_behind || !(common >= kInside * (e.u1 - e.u0)) ||
        e.v0 > group.height + 0.5 || e.v1 < -0.5)
      continue;
    const double beside = std::min(e.v1, group.height) - std::max(e.v0, 0.0);
    if (s.area_m2 >= params.least_area && beside < kInside * (e.v1 - e.v0))
      continue;  // an upper storey that stands back
    if (!is_wall_of_its_own(e, s, group.width, params)) taken[i] = 1;
    group.parallel.push_back({s.id, s.points});
  }
}

inline std::vector<WallGroup> find_walls(std::span<const Segment> segments, std::span<const Vec3> stations, Vec3 middle,
                                         const WallParams& params) {
  const double most_tilt = std::sqrt(1 - cos_degrees(params.lean_deg) * cos_degrees(params.lean_deg));
  std::vector<std::size_t> upright;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].area_m2 > 0 && std::abs(segments[i].plane.n.z) <= most_tilt) upright.push_back(i);
  std::vector<std::size_t> by_area = upright;
  std::sort(by_area.begin(), by_area.end(), [&](std::size_t a, std::size_t b) {
    return segments[a].area_m2 != segments[b].area_m2 ? segments[a].area_m2 > segments[b].area_m2 : a < b;
  });
  std::vector<char> taken(segments.size());
  std::vector<WallGroup> walls;
  for (const std::size_t i : by_area) {
    const Segment& s = segments[i];
    if (taken[i] != 0 || s.area_m2 < params.least_area / 4) continue;
    Vec3 out = street_side(s, stations, middle);
    if (stations.empty()) out = side_like(s, walls, params, out);
    WallGroup group = group_of(s, out);
    Extent all = extent_of(s, group.axes, params.metres_per_unit);
    std::vector<char> trial = taken;
    trial[i] = 1;
    join_coplanar(segments, by_area, trial, params, group, all);
    set_box(group, all, params.metres_per_unit);
    if (group.width < params.least_width || group.height < params.least_height || group.area_m2 < params.least_area)
      continue;
    taken = trial;
    claim_relief(segments, upright, taken, params, group);
    std::sort(group.segments.begin(), group.segments.end());
    walls.push_back(std::move(group));
  }
  std::sort(walls.begin(), walls.end(), [](const WallGroup& a, const WallGroup& b) {
    return a.area_m2 != b.area_m2 ? a.area_m2 > b.area_m2 : a.segments[0] < b.segments[0];
  });
  return walls;
}

inline std::vector<WallGroup> find_dormer_fronts(const WallGroup& wall, std::span<const WallGroup> walls,
                                                 std::span<const Segment> segments, WallParams params,
                                                 const DormerFrontParams& dormers = {}) {
  constexpr double kOverlap = 0.3;  // metres that they may reach down below the wall's top
  const double least_cos = cos_degrees(kParallelDeg);
  std::vector<char> taken(segments.size(), 0);
  for (const WallGroup& known : walls)
    for (const std::uint32_t id : known.segments) taken[id - 1] = 1;
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    if (taken[i] != 0 || !(s.area_m2 > 0) || std::abs(dot(s.plane.n, wall.axes.out)) < least_cos) continue;
    const Extent e = extent_of(s, wall.axes, params.metres_per_unit);
    if (e.w0 > params.bias || e.w0 < -dormers.behind || e.u0 < -kOverlap || e.u1 > wall.width + kOverlap ||
        e.v0 < wall.height - kOverlap || e.v1 > wall.height + dormers.reach || e.u1 - e.u0 > dormers.most_width)
      continue;
    candidates.push_back(i);
  }
  std::sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
    return segments[a].area_m2 != segments[b].area_m2 ? segments[a].area_m2 > segments[b].area_m2 : a < b;
  });
  params.gap = dormers.gap;
  std::vector<WallGroup> fronts;
  for (const std::size_t i : candidates) {
    if (taken[i] != 0) continue;
    taken[i] = 1;
    const Segment& s = segments[i];
    WallGroup front = group_of(s, dot(s.plane.n, wall.axes.out) > 0 ? s.plane.n : -1.0 * s.plane.n);
    Extent all = extent_of(s, front.axes, params.metres_per_unit);
    join_coplanar(segments, candidates, taken, params, front, all);
    set_box(front, all, params.metres_per_unit);
    if (front.width < dormers.least_width || front.height < dormers.least_height || front.width > dormers.most_width)
      continue;
    std::sort(front.segments.begin(), front.segments.end());
    const bool fills = std::any_of(fronts.begin(), fronts.end(), [&](const WallGroup& larger) {
      return common_share(front, larger, params.metres_per_unit) >= kInside;
    });
    if (!fills) fronts.push_back(std::move(front));
  }
  const auto left = [&](const WallGroup& f) { return dot(f.axes.origin - wall.axes.origin, wall.axes.right); };
  std::stable_sort(fronts.begin(), fronts.end(),
                   [&](const WallGroup& a, const WallGroup& b) { return left(a) < left(b); });
  return fronts;
}

}  // namespace ilot::test::plain_walls
