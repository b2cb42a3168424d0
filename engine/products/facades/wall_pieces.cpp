// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/wall_pieces.h"

#include <algorithm>
#include <cmath>

#include "engine/pass/pass.h"
#include "engine/products/facades/walls/segment_grid.h"
#include "engine/products/facades/walls/step_profile.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// The rectangle of a segment as a wall.
WallGroup wall_of(const Segment& s, double metres) {
  WallGroup wall;
  wall.axes.origin = s.centroid - signed_distance(s.plane, s.centroid) * s.plane.n;
  wall.axes.out = s.plane.n;
  const Vec3 right = cross(Vec3{0, 0, 1}, s.plane.n);
  wall.axes.right = (1 / norm(right)) * right;
  wall.axes.up = cross(wall.axes.out, wall.axes.right);
  const WallExtent e = extent_of(s, wall.axes, metres);
  wall.width = e.u1 - e.u0, wall.height = e.v1 - e.v0;
  wall.axes.origin = wall.axes.origin + (e.u0 / metres) * wall.axes.right + (e.v0 / metres) * wall.axes.up;
  wall.area_m2 = s.area_m2, wall.points = s.points, wall.epsilon = s.epsilon_m, wall.rms = s.rms_m;
  wall.segments = {s.id};
  return wall;
}

bool may_be_wall(const Segment& s, const WallGroup& wall, const WallParams& params) {
  return s.area_m2 >= params.least_area && wall.width >= params.least_width && wall.height >= params.least_height;
}

// The stretches of a segment; u begins `work.beside` to the left of it. Where the wall steps is seen by the points of
// all large planes near it: one of them may follow a house below and another one above.
std::vector<WallStretch> stretches_of(const FacadeWork& work, const Segment& s, const WallGroup& wall,
                                      const std::vector<bool>& large, const StepParams& params) {
  const double width = wall.width + 2 * work.beside;
  StepProfile all(width, wall.height, s.points), own(width, wall.height, s.points);
  gather_facade(work, wall).points([&](std::span<const FacadePoint> points, std::span<const SiteStation>) {
    for (FacadePoint p : points) {
      if (p.v < 0 || static_cast<double>(p.v) > wall.height) continue;
      p.u += static_cast<float>(work.beside);
      if (large[p.plane]) all.add(p);
      if (p.plane == s.id) own.add(p);
    }
  });
  return own.stretches(params, all.steps(params), all);
}

// Turns metres in the axes of a wall into CRS units.
struct IntoCrs {
  const FacadeAxes& axes;
  double metres, beside;  // u begins so far beside the wall
  Vec3 of(double u, double v, double w) const {
    return axes.origin + (1 / metres) * ((u - beside) * axes.right + v * axes.up + w * axes.out);
  }
  Vec3 normal(const LocalPlane& p) const {
    const Vec3 n = axes.out - p.along * axes.right - p.up * axes.up;
    return (1 / norm(n)) * n;
  }
  EndPlane end(const LocalPlane& p, double u, const WallStretch& s, bool step) const {
    const double v = (s.v0 + s.v1) / 2;
    return {of(u, v, p.w(u, v)), normal(p), s.v1 - s.v0, p.error, step};
  }
};

Segment piece_of(const Segment& s, const WallStretch& t, const IntoCrs& into) {
  Segment piece = s;
  const double u = (t.u0 + t.u1) / 2, v = (t.v0 + t.v1) / 2;
  piece.plane.n = into.normal(t.plane);
  piece.centroid = into.of(u, v, t.plane.w(u, v));
  piece.plane.d = -dot(piece.plane.n, piece.centroid);
  piece.min = {INFINITY, INFINITY, INFINITY}, piece.max = {-INFINITY, -INFINITY, -INFINITY};
  for (const double cu : {t.u0, t.u1})
    for (const double cv : {t.v0, t.v1}) {
      const Vec3 p = into.of(cu, cv, t.plane.w(cu, cv));
      piece.min = {std::min(piece.min.x, p.x), std::min(piece.min.y, p.y), std::min(piece.min.z, p.z)};
      piece.max = {std::max(piece.max.x, p.x), std::max(piece.max.y, p.y), std::max(piece.max.z, p.z)};
    }
  piece.points = t.points;
  piece.area_m2 = s.area_m2 * static_cast<double>(t.points) / static_cast<double>(std::max<std::uint64_t>(s.points, 1));
  piece.rms_m = t.rms;
  return piece;
}

}  // namespace

WallPieces wall_pieces(const FacadeWork& work, std::span<const Segment> segments, const WallParams& params,
                       const PassContext& context) {
  // Choice: planes that one plane follows across several houses are nearer to it.
  constexpr double kBeyond = 0.1;  // metres
  const double most_tilt = std::sqrt(1 - cos_degrees(params.lean_deg) * cos_degrees(params.lean_deg));
  // Derived: a majority; a plane that follows several houses takes scattered points of others.
  constexpr double kMost = 0.5;  // share of the points
  FacadeWork own = work;
  own.stations = {}, own.steps = {}, own.outlines = {}, own.outline_numbers.clear(), own.recorded = false;
  own.beside = params.least_width;
  const StepParams steps{params.least_step, params.least_width, params.least_height, params.gap};
  std::vector<std::size_t> large;
  std::vector<WallGroup> walls;
  std::vector<PassTask> tasks;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    if (!(s.area_m2 > 0) || std::abs(s.plane.n.z) > most_tilt) continue;
    WallGroup wall = wall_of(s, work.metres_per_unit);
    if (!may_be_wall(s, wall, params)) continue;
    own.before = own.behind = std::max(own.before, s.epsilon_m + kBeyond);
    tasks.push_back({2 * StepProfile::bytes(wall.width + 2 * own.beside, wall.height, s.points), s.points});
    large.push_back(i), walls.push_back(std::move(wall));
  }
  std::uint32_t last = 0;
  for (const Segment& s : segments) last = std::max(last, s.id);
  std::vector<bool> is_large(last + std::size_t{1}, false);
  for (const std::size_t i : large) is_large[segments[i].id] = true;
  std::vector<std::vector<WallStretch>> found(large.size());
  run_pass(tasks, context.budget_bytes,
           [&](std::size_t k) { found[k] = stretches_of(own, segments[large[k]], walls[k], is_large, steps); });
  WallPieces pieces;
  std::size_t k = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool profiled = k < large.size() && large[k] == i;
    if (!profiled || found[k].empty()) {
      pieces.segments.push_back(segments[i]), pieces.ends.emplace_back();
      k += profiled;
      continue;
    }
    const IntoCrs into{walls[k].axes, work.metres_per_unit, own.beside};
    for (const WallStretch& t : found[k]) {
      const Segment& s =
          pieces.segments.emplace_back(found[k].size() > 1 ? piece_of(segments[i], t, into) : segments[i]);
      const bool known = t.v1 - t.v0 >= params.least_height, stray = t.share < kMost;
      const bool wide = known && !stray && t.u1 - t.u0 >= params.least_width && s.area_m2 >= params.least_area;
      pieces.ends.push_back(
          {known, wide, stray, into.end(t.left, t.u0, t, t.left_step), into.end(t.right, t.u1, t, t.right_step)});
    }
    ++k;
  }
  return pieces;
}

}  // namespace ilot
