// SPDX-License-Identifier: Apache-2.0
// The joints of facades as engine/products/facades/walls/facade_joints.h finds them. Here every facade is compared with
// all others: this is slow and easy to read.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/products/facades/walls/facade_joints.h"
#include "engine/products/facades/walls/side_faces.h"
#include "kernels/core/portable_math.h"

namespace ilot::test::plain_joints {

constexpr double kParallelDeg = 5;
constexpr double kOver = 0.5;        // share of the narrower wall that is over the other
constexpr double kSameHeight = 0.5;  // share of the lower wall that is beside the other at a corner

inline FacadeElement* outline_of(Facade& facade) {
  const auto at = std::find_if(facade.elements.begin(), facade.elements.end(), [](const FacadeElement& e) {
    return e.region == FacadeRegion::facade && e.ring.size() >= 4;
  });
  return at == facade.elements.end() ? nullptr : &*at;
}

// Outlines begin with their lower left and lower right corners (see wall_outline.h).
struct EndCorners {
  std::size_t low, high;
};
inline EndCorners end_of(const FacadeElement& outline, bool left) {
  return left ? EndCorners{0, outline.ring.size() - 1} : EndCorners{1, 2};
}

// Returns u, v and w of a position, in metres.
inline Vec3 local(const Facade& f, Vec3 place, double metres) {
  const Vec3 d = metres * (place - f.origin);
  return {dot(d, f.right), dot(d, f.up), dot(d, f.out)};
}

inline Box2 box_of(const Facade& f, const FacadeElement& e, double metres) {
  Box2 box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const Vec3& p : e.ring) {
    const Vec3 q = local(f, p, metres);
    box = {std::min(box.u0, q.x), std::max(box.u1, q.x), std::min(box.v0, q.y), std::max(box.v1, q.y)};
  }
  return box;
}

// Returns the distance in metres along the wall from a position on it to the plane of another facade.
inline double way_to(const Facade& from, Vec3 place, const Facade& to, double metres) {
  return dot(to.origin - place, to.out) / dot(from.right, to.out) * metres;
}

// Returns how much the top rises per metre to the right at an end of the wall.
inline double rise_at(const Facade& f, const FacadeElement& outline, bool left) {
  const std::size_t high = end_of(outline, left).high, next = left ? high - 1 : high + 1;
  const Vec3 along = outline.ring[next] - outline.ring[high];
  const double across = dot(along, f.right);
  return outline.edges.empty() || across == 0 ? 0 : dot(along, f.up) / across;
}

struct Meeting {
  double way = INFINITY;  // metres by which the end moves
  std::size_t other = 0;  // the facade that it meets
};

// Returns the facade that the left (or right) end of a facade meets.
inline Meeting meeting_of(std::vector<Facade>& facades, std::size_t own, bool left, const JointParams& params) {
  Meeting nearest;
  Facade& f = facades[own];
  const FacadeElement* outline = outline_of(f);
  const double m = params.metres_per_unit, least = cos_degrees(90 - params.least_turn_deg);
  const EndCorners end = end_of(*outline, left);
  const Vec3 low = outline->ring[end.low], high = outline->ring[end.high];
  for (std::size_t o = 0; o < facades.size(); ++o) {
    FacadeElement* other = o == own ? nullptr : outline_of(facades[o]);
    if (other == nullptr || std::abs(dot(f.right, facades[o].out)) < least) continue;
    const Vec3 middle = 0.5 * (low + high);
    const double way = way_to(f, middle, facades[o], m);
    if (std::abs(way) > params.reach || std::abs(way) >= std::abs(nearest.way)) continue;
    const Vec3 line = local(facades[o], middle + (way / m) * f.right, m);
    const Box2 box = box_of(facades[o], *other, m);
    const double own_low = local(facades[o], low, m).y, own_high = local(facades[o], high, m).y;
    const double common = std::min(own_high, box.v1) - std::max(own_low, box.v0);
    const bool beside = common >= kSameHeight * std::min(own_high - own_low, box.height());
    if (line.x < box.u0 - params.reach || line.x > box.u1 + params.reach || !beside) continue;
    nearest = {way, o};
  }
  return nearest;
}

inline void begin_at_left_end(Facade& f, const FacadeElement& outline, double metres) {
  const Box2 box = box_of(f, outline, metres);
  f.origin = f.origin + (box.u0 / metres) * f.right + (box.v0 / metres) * f.up;
  f.width_m = box.width();
  f.height_m = box.height();
}

// Joins corners of two outlines that are on one vertical line and differ in height by at most `reach`.
inline void join_heights(std::vector<Facade>& facades, double reach, double metres) {
  std::vector<Vec3*> corners;
  for (Facade& f : facades)
    if (FacadeElement* outline = outline_of(f))
      for (const bool left : {true, false}) {
        const EndCorners end = end_of(*outline, left);
        corners.push_back(&outline->ring[end.low]);
        corners.push_back(&outline->ring[end.high]);
      }
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = a + 1; b < corners.size(); ++b) {
      const Vec3 apart = metres * (*corners[b] - *corners[a]);
      constexpr double kOnLine = 0.02;  // metres: tolerance for a vertical line in which walls meet
      if (apart.x * apart.x + apart.y * apart.y > kOnLine * kOnLine || std::abs(apart.z) > reach) continue;
      const Vec3 middle = 0.5 * (*corners[a] + *corners[b]);
      *corners[a] = *corners[b] = middle;
    }
}

inline FacadeElement step_of(const Facade& wall, const FacadeElement& outline, double depth, double m) {
  FacadeElement e;
  e.kind = depth > 0 ? "protrusion" : "recess";
  e.id = static_cast<std::uint32_t>(wall.elements.size() + 1);
  const Box2 box = box_of(wall, outline, m);
  const auto place = [&](double u, double v) { return wall.origin + (u / m) * wall.right + (v / m) * wall.up; };
  if (outline.edges.empty()) {  // a rectangle
    e.ring = {place(box.u0, box.v0), place(box.u1, box.v0), place(box.u1, box.v1), place(box.u0, box.v1)};
    for (std::size_t i = 0; i < e.ring.size(); ++i)
      e.edges.push_back({DrawnStatus::seen, 0, 0, i % 2 == 0 ? outline.height_error_m : outline.width_error_m, 0});
  } else {
    e.edges = outline.edges;
    for (const Vec3& p : outline.ring) {
      const Vec3 at = local(wall, p, m);
      e.ring.push_back(place(at.x, at.y));
    }
  }
  e.width_m = box.width();
  e.height_m = box.height();
  e.depth_m = depth;
  e.width_error_m = outline.width_error_m;
  e.height_error_m = outline.height_error_m;
  e.depth_error_m = outline.depth_error_m;
  e.points = outline.points;
  if (!outline.edges.empty()) return e;  // its ring and its depth describe it completely
  FacadeSite site;
  site.axes = {wall.origin, wall.right, wall.up, wall.out};
  site.metres_per_unit = m;
  e.body = body_between(site, box, 0, box, depth);
  return e;
}

// Returns how far `part` stands before `wall` if it is a storey of the same front. Returns 0 otherwise.
inline double step_between(const Facade& wall, const Box2& own, const Facade& part, const FacadeElement& outline,
                           const JointParams& params) {
  const double m = params.metres_per_unit;
  if (dot(wall.out, part.out) < cos_degrees(kParallelDeg)) return 0;
  const Box2 box = box_of(wall, outline, m);
  const double depth = local(wall, 0.5 * (outline.ring[0] + outline.ring[2]), m).z;
  if (std::abs(depth) < params.least_step || std::abs(depth) > params.most_step) return 0;
  const double over = std::min(own.u1, box.u1) - std::max(own.u0, box.u0);
  const double gap = std::max(own.v0, box.v0) - std::min(own.v1, box.v1);
  return over >= kOver * std::min(own.width(), box.width()) && std::abs(gap) <= params.reach ? depth : 0;
}

inline void close_corners(std::vector<Facade>& facades, const JointParams& params) {
  for (std::size_t i = 0; i < facades.size(); ++i) {
    if (outline_of(facades[i]) == nullptr) continue;
    for (const bool left : {true, false}) {
      const Meeting met = meeting_of(facades, i, left, params);
      if (!std::isfinite(met.way)) continue;
      FacadeElement* outline = outline_of(facades[i]);
      // Each end of the side is moved by itself, because the line may lean as much as the walls do.
      const EndCorners end = end_of(*outline, left);
      for (const std::size_t corner : {end.low, end.high}) {
        const double m = params.metres_per_unit;
        const Vec3 p = outline->ring[corner];
        const double way = way_to(facades[i], p, facades[met.other], m) / m;
        outline->ring[corner] =
            p +
            way * (facades[i].right + (corner == end.high ? rise_at(facades[i], *outline, left) : 0.0) * facades[i].up);
      }
    }
  }
  join_heights(facades, params.reach, params.metres_per_unit);
  for (Facade& f : facades)
    if (FacadeElement* outline = outline_of(f)) {
      const Box2 box = box_of(f, *outline, params.metres_per_unit);
      outline->width_m = box.width();
      outline->height_m = box.height();
      begin_at_left_end(f, *outline, params.metres_per_unit);
    }
}

inline void add_storey_steps(std::vector<Facade>& facades, const JointParams& params) {
  const double m = params.metres_per_unit;
  for (std::size_t i = 0; i < facades.size(); ++i)
    for (std::size_t k = 0; k < facades.size(); ++k) {
      FacadeElement *own = outline_of(facades[i]), *other = outline_of(facades[k]);
      if (i == k || own == nullptr || other == nullptr) continue;
      const Box2 box = box_of(facades[i], *own, m), part = box_of(facades[k], *other, m);
      const double area = box.width() * box.height(), smaller = part.width() * part.height();
      if (smaller > area || (smaller == area && k < i)) continue;
      const double depth = step_between(facades[i], box, facades[k], *other, params);
      if (depth == 0) continue;
      FacadeElement step = step_of(facades[i], *other, depth, m);
      facades[i].elements.push_back(std::move(step));
    }
}

}  // namespace ilot::test::plain_joints
