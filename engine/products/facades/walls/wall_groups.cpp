// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_groups.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/products/facades/walls/segment_grid.h"
#include "engine/products/facades/walls/wall_ends.h"
#include "engine/products/facades/walls/wall_parts.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: relief that is twisted by more is a wall of its own.
constexpr double kParallelDeg = 5;  // greatest angle between a plane of the relief and its wall
// Choice: over 2 m, 2 degrees are 7 cm, more than facades.bias; walls that bend by less become one.
constexpr double kCoplanarDeg = 2;  // greatest angle between parts of one wall
// Choice: cornices and plinths reach beyond a wall by less.
constexpr double kBelow = 0.5;  // metres above and below a wall in which its relief may be
// Derived: a majority.
constexpr double kInside = 0.5;  // share of the width of a plane that must be along the wall so that it is relief

FacadeAxes axes_of(const Segment& s, Vec3 out) {
  FacadeAxes axes;
  axes.out = out;
  axes.origin = s.centroid - signed_distance(s.plane, s.centroid) * s.plane.n;
  const Vec3 right = cross(Vec3{0, 0, 1}, out);
  axes.right = (1 / norm(right)) * right;
  axes.up = cross(axes.out, axes.right);
  return axes;
}

// A direction of the street, and the log odds that it is right.
struct StreetSide {
  Vec3 out;
  double odds = 0;
};

// The difference of the votes for the side of the normal and for the other side.
double votes_of_stations(const Segment& s, std::span<const Vec3> stations) {
  double vote = 0;
  for (const Vec3& station : stations) {
    const double off = signed_distance(s.plane, station), far = norm(station - s.centroid);
    if (off != 0 && far > 0) vote += (off > 0 ? 1 : -1) / (far * far);
  }
  return vote;
}

// The side of a larger wall in line: a storey that is set back faces the same way as the wall below it. Otherwise the
// side away from the middle.
StreetSide side_of_others(const Segment& s, const std::vector<WallGroup>& walls, const WallParams& params,
                          Vec3 middle) {
  for (const WallGroup& wall : walls) {
    const double off = dot(s.centroid - wall.axes.origin, wall.axes.out) * params.metres_per_unit;
    if (std::abs(dot(s.plane.n, wall.axes.out)) < cos_degrees(kParallelDeg) || std::abs(off) > params.relief_behind)
      continue;
    return {dot(s.plane.n, wall.axes.out) > 0 ? s.plane.n : -1.0 * s.plane.n, 0};
  }
  return {signed_distance(s.plane, middle) > 0 ? -1.0 * s.plane.n : s.plane.n, 0};
}

StreetSide street_side_of(const Segment& s, const StreetSides& sides, const std::vector<WallGroup>& walls,
                          const WallParams& params) {
  // Choice: odds of 1.3 to 1 are chance; the rules for walls without evidence are as good.
  constexpr double kChance = 0.3;
  const auto towards = [&](double sign) { return sign > 0 ? s.plane.n : -1.0 * s.plane.n; };
  if (const double vote = votes_of_stations(s, sides.stations); vote != 0) return {towards(vote), INFINITY};
  const double odds = sides.odds.empty() ? 0 : sides.odds[s.id];
  if (std::abs(odds) >= kChance) return {towards(odds), std::abs(odds)};
  return side_of_others(s, walls, params, sides.middle);
}

void include(WallExtent& all, const WallExtent& e) {
  all.u0 = std::min(all.u0, e.u0);
  all.u1 = std::max(all.u1, e.u1);
  all.v0 = std::min(all.v0, e.v0);
  all.v1 = std::max(all.v1, e.v1);
}

// Whether a segment is on the plane of the wall.
bool is_coplanar(const Segment& s, const WallGroup& group, const WallParams& params) {
  if (std::abs(dot(s.plane.n, group.axes.out)) < cos_degrees(kCoplanarDeg)) return false;
  const double off = s.area_m2 < params.large_part ? std::min(params.bias, s.epsilon_m) : params.bias;
  return std::abs(extent_of(s, group.axes, params.metres_per_unit).w0) <= off;
}

bool are_apart(const WallExtent& e, const WallExtent& all, double gap) {
  return e.u0 > all.u1 + gap || e.u1 < all.u0 - gap || e.v0 > all.v1 + gap || e.v1 < all.v0 - gap;
}

// Adds the segments that lie on the plane of the wall and continue it, until there are no more. Each round goes through
// them in the order of the list of the grid. Returns the segments and marks them as taken.
std::vector<std::size_t> join_coplanar(const SegmentGrid& grid, std::vector<char>& taken, const WallParams& params,
                                       WallGroup& group, WallExtent& all, std::vector<KnownPart>* parts = nullptr,
                                       std::span<const SegmentEnds> ends = {}) {
  std::vector<std::size_t> joined;
  std::set<std::uint32_t> waiting, apart;  // on the plane and not far away; beyond a step
  const auto look_around = [&] {
    const WallExtent around{all.u0 - params.gap, all.u1 + params.gap, all.v0 - params.gap,
                            all.v1 + params.gap, -params.bias,        params.bias};
    for (const std::uint32_t k : grid.near(group.axes, around))
      if (taken[grid.index(k)] == 0 && !apart.contains(k) && is_coplanar(grid.segment(k), group, params))
        waiting.insert(k);
  };
  look_around();
  for (bool more = true; more;) {
    more = false;
    for (auto at = waiting.begin(); at != waiting.end();) {
      const std::uint32_t k = *at;
      const Segment& s = grid.segment(k);
      const WallExtent e = extent_of(s, group.axes, params.metres_per_unit);
      if (are_apart(e, all, params.gap)) {
        ++at;
        continue;
      }
      const bool high = parts != nullptr && e.v1 - e.v0 >= params.least_height / 2;
      if (high && is_far(e, *parts, params.gap)) {
        ++at;
        continue;
      }
      if (high && steps_off(e, grid.index(k), *parts, ends, params)) {
        at = waiting.erase(at);
        apart.insert(k);
        continue;
      }
      if (high && !ends[grid.index(k)].stray)
        parts->push_back({e, grid.index(k), ends[grid.index(k)].known, ends[grid.index(k)].wide});
      taken[grid.index(k)] = 1;
      joined.push_back(grid.index(k));
      include(all, e);
      group.segments.push_back(s.id);
      group.points += s.points;
      group.area_m2 += s.area_m2;
      group.epsilon = std::max(group.epsilon, s.epsilon_m);
      more = true;
      waiting.erase(at);
      look_around();
      at = waiting.upper_bound(k);
    }
  }
  return joined;
}

// A group of one segment.
WallGroup group_of(const Segment& s, Vec3 out) {
  WallGroup group;
  group.axes = axes_of(s, out);
  group.segments = {s.id};
  group.points = s.points;
  group.area_m2 = s.area_m2;
  group.epsilon = s.epsilon_m;
  group.rms = s.rms_m;
  return group;
}

void set_box(WallGroup& group, const WallExtent& all, double metres) {
  group.width = all.u1 - all.u0;
  group.height = all.v1 - all.v0;
  group.axes.origin = group.axes.origin + (all.u0 / metres) * group.axes.right + (all.v0 / metres) * group.axes.up;
}

// The share of a front that another one covers, seen perpendicular to it.
double common_share(const WallGroup& front, const WallGroup& other, double metres) {
  const Vec3 d = metres * (front.axes.origin - other.axes.origin);
  const double u = dot(d, other.axes.right), v = dot(d, other.axes.up);
  const double across = std::min(u + front.width, other.width) - std::max(u, 0.0);
  const double up = std::min(v + front.height, other.height) - std::max(v, 0.0);
  return std::max(across, 0.0) * std::max(up, 0.0) / (front.width * front.height);
}

// Whether relief of a wall is a wall of its own too: what is as high as two storeys before the wall or behind it, and a
// storey that stands back.
bool is_wall_of_its_own(const WallExtent& e, const Segment& s, double wall_width, const WallParams& params) {
  // Choice: pilasters, leaves and panes are nearer to their wall.
  constexpr double kOff = 0.1;  // metres before or behind its wall
  // Choice: fronts of balconies, bays of one storey, vans and hedges are lower.
  constexpr double kTwoStoreys = 4;  // metres
  // Derived: a majority; scaffolds and fences cover less of their boxes.
  constexpr double kCovered = 0.5;  // share of its box that its points cover
  // Choice: a storey of which windows take more is glass.
  constexpr double kCoveredStorey = 0.3;  // the same of a storey, half of whose length may be windows
  // Derived: a majority; shop windows and niches are narrower.
  constexpr double kStoreyShare = 0.5;  // share of the width of its wall that a storey takes
  const double width = e.u1 - e.u0, height = e.v1 - e.v0;
  if (std::abs(e.w0) <= kOff || width < params.least_width || s.area_m2 < params.least_area) return false;
  if (height >= kTwoStoreys) return s.area_m2 >= kCovered * width * height;
  return e.w0 < 0 && height >= params.least_height && width >= kTwoStoreys && width >= kStoreyShare * wall_width &&
         s.area_m2 >= kCoveredStorey * width * height;
}

// Claims segments that are parallel to the wall and along it, so that a balcony or a shop front does not become a
// facade; what is a wall of its own is relief and becomes a facade. The segments of the wall are in order.
void claim_relief(const SegmentGrid& grid, std::vector<char>& taken, const WallParams& params,
                  std::span<const KnownPart> parts, WallGroup& group) {
  const double least_cos = cos_degrees(kParallelDeg);
  const WallExtent around{0, group.width, -kBelow, group.height + kBelow, -params.relief_behind, params.relief_front};
  std::vector<std::size_t> candidates;
  for (const std::uint32_t k : grid.near(group.axes, around)) candidates.push_back(k);
  std::sort(candidates.begin(), candidates.end(),
            [&](std::size_t a, std::size_t b) { return grid.index(a) < grid.index(b); });
  for (const std::size_t k : candidates) {
    const Segment& s = grid.segment(k);
    if (std::abs(dot(s.plane.n, group.axes.out)) < least_cos) continue;
    if (std::binary_search(group.segments.begin(), group.segments.end(), s.id)) continue;
    const WallExtent e = extent_of(s, group.axes, params.metres_per_unit);
    const double common = std::min(e.u1, group.width) - std::max(e.u0, 0.0);
    if (e.w0 > params.relief_front || e.w0 < -params.relief_behind || !(common >= kInside * (e.u1 - e.u0)) ||
        e.v0 > group.height + kBelow || e.v1 < -kBelow)
      continue;
    const double beside = std::min(e.v1, group.height) - std::max(e.v0, 0.0);
    if (s.area_m2 >= params.least_area && beside < kInside * (e.v1 - e.v0))
      continue;  // an upper storey that is set back
    if (!parts.empty() && is_beside(e, s, parts, params)) continue;
    if (!is_wall_of_its_own(e, s, group.width, params)) taken[grid.index(k)] = 1;
    group.parallel.push_back({s.id, s.points});
  }
}

}  // namespace

std::vector<WallGroup> find_walls(std::span<const Segment> segments, const StreetSides& sides, const WallParams& params,
                                  std::span<const SegmentEnds> ends) {
  const double most_tilt = std::sqrt(1 - cos_degrees(params.lean_deg) * cos_degrees(params.lean_deg));
  std::vector<std::size_t> by_area;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].area_m2 > 0 && std::abs(segments[i].plane.n.z) <= most_tilt) by_area.push_back(i);
  std::sort(by_area.begin(), by_area.end(), [&](std::size_t a, std::size_t b) {
    return segments[a].area_m2 != segments[b].area_m2 ? segments[a].area_m2 > segments[b].area_m2 : a < b;
  });
  const SegmentGrid upright(segments, std::move(by_area), params.metres_per_unit);
  std::vector<char> taken(segments.size());
  std::vector<WallGroup> walls;
  for (const std::size_t i : upright.list()) {
    const Segment& s = segments[i];
    if (taken[i] != 0 || s.area_m2 < params.least_area / 4) continue;
    const StreetSide side = street_side_of(s, sides, walls, params);
    WallGroup group = group_of(s, side.out);
    group.side_odds = side.odds;
    WallExtent all = extent_of(s, group.axes, params.metres_per_unit);
    taken[i] = 1;
    std::vector<KnownPart> parts;
    if (!ends.empty()) parts.push_back({all, i});
    const std::vector<std::size_t> joined =
        join_coplanar(upright, taken, params, group, all, ends.empty() ? nullptr : &parts, ends);
    set_box(group, all, params.metres_per_unit);
    group.core0 = group.width, group.core1 = 0;
    for (KnownPart& part : parts)  // the origin has moved
      part.box.u0 -= all.u0, part.box.u1 -= all.u0, part.box.v0 -= all.v0, part.box.v1 -= all.v0;
    for (const KnownPart& part : parts) {
      const WallExtent stretch{part.box.u0, part.box.u1, 0, group.height, 0, 0};
      if (part.known || are_along(stretch, parts))
        group.core0 = std::min(group.core0, part.box.u0), group.core1 = std::max(group.core1, part.box.u1);
    }
    if (group.width < params.least_width || group.height < params.least_height || group.area_m2 < params.least_area) {
      taken[i] = 0;
      for (const std::size_t j : joined) taken[j] = 0;
      continue;
    }
    std::sort(group.segments.begin(), group.segments.end());
    group.segments.erase(std::unique(group.segments.begin(), group.segments.end()), group.segments.end());
    claim_relief(upright, taken, params, parts, group);
    walls.push_back(std::move(group));
  }
  std::sort(walls.begin(), walls.end(), [](const WallGroup& a, const WallGroup& b) {
    return a.area_m2 != b.area_m2 ? a.area_m2 > b.area_m2 : a.segments[0] < b.segments[0];
  });
  if (!ends.empty()) end_at_neighbours(walls, params);
  return walls;
}

std::vector<WallGroup> small_walls(std::span<const WallGroup> walls, std::span<const Segment> segments,
                                   const StreetSides& sides, WallParams params, std::span<const SegmentEnds> ends) {
  // Choice: a storey that is set back is about half as high; lower walls form no corners.
  constexpr double kLeast = 0.5;  // share of the width and height of a facade
  std::uint32_t last = 0;
  for (const Segment& s : segments) last = std::max(last, s.id);
  std::vector<std::uint8_t> known(last + std::size_t{1}, 0);
  for (const WallGroup& wall : walls) {
    for (const std::uint32_t id : wall.segments) known[id] = 1;
    for (const ParallelPlane& plane : wall.parallel) known[plane.id] = 1;
  }
  params.least_width *= kLeast, params.least_height *= kLeast, params.least_area *= kLeast * kLeast;
  std::vector<WallGroup> small = find_walls(segments, sides, params, ends);
  std::erase_if(small, [&](const WallGroup& wall) {
    return std::any_of(wall.segments.begin(), wall.segments.end(), [&](std::uint32_t id) { return known[id] != 0; });
  });
  return small;
}

struct DormerFronts::State {
  std::span<const Segment> segments;
  WallParams params;
  DormerFrontParams dormers;
  SegmentGrid upright;
  std::vector<char> taken;  // by walls, and by fronts while those of one wall are searched
};

DormerFronts::DormerFronts(std::span<const WallGroup> walls, std::span<const Segment> segments, WallParams params,
                           const DormerFrontParams& dormers) {
  // Derived: the sine of 30 degrees, far beyond facades.lean.
  constexpr double kMostTilt = 0.5;  // sine of an angle: walls and the planes parallel to them lean much less
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].area_m2 > 0 && std::abs(segments[i].plane.n.z) <= kMostTilt) list.push_back(i);
  params.gap = dormers.gap;
  state_ = std::make_unique<State>(State{segments, params, dormers,
                                         SegmentGrid(segments, std::move(list), params.metres_per_unit),
                                         std::vector<char>(segments.size(), 0)});
  for (const WallGroup& known : walls)
    for (const std::uint32_t id : known.segments) state_->taken[id - 1] = 1;
}

DormerFronts::~DormerFronts() = default;

// The segments that may be part of a front, the largest first.
std::vector<std::size_t> DormerFronts::candidates(const WallGroup& wall) const {
  // Choice: the overhang of a roof; a dormer that begins lower is a part of the wall.
  constexpr double kOverlap = 0.3;  // metres that they may reach below the top of the wall and beyond its ends
  const State& in = *state_;
  const WallExtent around{
      -kOverlap,          wall.width + kOverlap, wall.height - kOverlap, wall.height + in.dormers.reach,
      -in.dormers.behind, in.params.bias};
  std::vector<std::size_t> found;
  for (const std::uint32_t k : in.upright.near(wall.axes, around)) {
    const Segment& s = in.upright.segment(k);
    if (in.taken[in.upright.index(k)] != 0 || std::abs(dot(s.plane.n, wall.axes.out)) < cos_degrees(kParallelDeg))
      continue;
    const WallExtent e = extent_of(s, wall.axes, in.params.metres_per_unit);
    if (e.w0 > around.w1 || e.w0 < around.w0 || e.u0 < around.u0 || e.u1 > around.u1 || e.v0 < around.v0 ||
        e.v1 > around.v1 || e.u1 - e.u0 > in.dormers.most_width)
      continue;
    found.push_back(in.upright.index(k));
  }
  std::sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) {
    const double p = in.segments[a].area_m2, q = in.segments[b].area_m2;
    return p != q ? p > q : a < b;
  });
  return found;
}

std::vector<WallGroup> DormerFronts::of(const WallGroup& wall) {
  State& in = *state_;
  const double metres = in.params.metres_per_unit;
  const SegmentGrid parts(in.segments, candidates(wall), metres);
  std::vector<WallGroup> fronts;
  for (const std::size_t i : parts.list()) {
    if (in.taken[i] != 0) continue;
    in.taken[i] = 1;
    const Segment& s = in.segments[i];
    WallGroup front = group_of(s, dot(s.plane.n, wall.axes.out) > 0 ? s.plane.n : -1.0 * s.plane.n);
    WallExtent all = extent_of(s, front.axes, metres);
    join_coplanar(parts, in.taken, in.params, front, all);
    set_box(front, all, metres);
    if (front.width < in.dormers.least_width || front.height < in.dormers.least_height ||
        front.width > in.dormers.most_width)
      continue;
    std::sort(front.segments.begin(), front.segments.end());
    const bool fills = std::any_of(fronts.begin(), fronts.end(), [&](const WallGroup& larger) {
      return common_share(front, larger, metres) >= kInside;
    });
    if (!fills) fronts.push_back(std::move(front));
  }
  for (const std::size_t i : parts.list()) in.taken[i] = 0;
  const auto left = [&](const WallGroup& f) { return dot(f.axes.origin - wall.axes.origin, wall.axes.right); };
  std::stable_sort(fronts.begin(), fronts.end(),
                   [&](const WallGroup& a, const WallGroup& b) { return left(a) < left(b); });
  return fronts;
}

Facade bare_facade(const WallGroup& wall, double metres_per_unit) {
  Facade f;
  f.origin = wall.axes.origin, f.right = wall.axes.right, f.up = wall.axes.up, f.out = wall.axes.out;
  f.width_m = wall.width, f.height_m = wall.height;
  FacadeElement e;
  e.region = FacadeRegion::facade;
  const Vec3 across = (wall.width / metres_per_unit) * f.right, up = (wall.height / metres_per_unit) * f.up;
  e.ring = {f.origin, f.origin + across, f.origin + across + up, f.origin + up};
  e.width_m = wall.width, e.height_m = wall.height;
  e.width_error_m = e.height_error_m = std::sqrt(wall.area_m2 / static_cast<double>(wall.points));
  e.depth_error_m = wall.epsilon;
  e.points = wall.points;
  f.elements = {e};
  return f;
}

}  // namespace ilot
