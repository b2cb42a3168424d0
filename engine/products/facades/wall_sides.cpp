// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/wall_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/products/facades/walls/street_side.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: as deep as rooms are that a scanner sees into; time and memory depend on it.
constexpr double kDeep = 4;  // metres on both sides
// Choice: fronts of one row; beyond it another row begins.
constexpr double kInLine = 1.5, kInLineDeg = 5;  // metres between the planes of two walls; angle between them
// Choice: storeys stand out or back by less. A wall below another one begins or ends within 30 cm of its foot or top.
constexpr double kStoreyOff = 3, kStoreyGap = 0.3;  // metres
// Choice: odds of three to one; a wall that is surer does not ask its neighbours, and none of them counts for more.
constexpr double kSure = 1.1;
// Choice: images and sample of one wall are smaller.
constexpr std::uint64_t kBytes = 16 << 20;

// Where a parallel wall lies in the axes of another one, in metres.
struct Beside {
  double from = INFINITY, to = -INFINITY;  // along it
  double low = INFINITY, high = -INFINITY;
  double off = INFINITY;  // distance of the planes
};

Beside beside(const WallGroup& a, const WallGroup& b, double metres) {
  const Vec3 across = (b.width / metres) * b.axes.right, up = (b.height / metres) * b.axes.up;
  Beside at;
  for (const Vec3& corner : {b.axes.origin, b.axes.origin + across, b.axes.origin + up}) {
    const Vec3 d = metres * (corner - a.axes.origin);
    at.from = std::min(at.from, dot(d, a.axes.right)), at.to = std::max(at.to, dot(d, a.axes.right));
    at.low = std::min(at.low, dot(d, a.axes.up)), at.high = std::max(at.high, dot(d, a.axes.up));
    at.off = std::min(at.off, std::abs(dot(d, a.axes.out)));
  }
  return at;
}

bool parallel(const WallGroup& a, const WallGroup& b) {
  return std::abs(dot(a.axes.out, b.axes.out)) >= cos_degrees(kInLineDeg);
}

// Whether two walls lie in one line along the street, beside each other or one before the other.
bool in_line(const WallGroup& a, const WallGroup& b, double gap, double metres) {
  if (!parallel(a, b)) return false;
  const Beside at = beside(a, b, metres);
  return at.off <= kInLine && at.from <= a.width + gap && at.to >= -gap;
}

// Whether the second wall is that of a storey above or below the first one, along half of it at least.
bool another_storey(const WallGroup& a, const WallGroup& b, double metres) {
  if (!parallel(a, b)) return false;
  const Beside at = beside(a, b, metres);
  return at.off <= kStoreyOff && std::min(at.to, a.width) - std::max(at.from, 0.0) >= a.width / 2 &&
         (at.low >= a.height - kStoreyGap || at.high <= kStoreyGap);
}

}  // namespace

double storey_odds(std::span<const WallGroup> walls, std::span<const double> own, std::size_t i,
                   double metres_per_unit) {
  std::size_t best = i;
  for (std::size_t k = 0; k < walls.size(); ++k)
    if (walls[k].area_m2 > walls[best].area_m2 && std::abs(own[k]) >= kSure &&
        another_storey(walls[i], walls[k], metres_per_unit))
      best = k;
  return dot(walls[i].axes.out, walls[best].axes.out) > 0 ? own[best] : -own[best];
}

std::vector<double> wall_side_odds(const FacadeWork& work, std::span<const WallGroup> walls, double gap,
                                   const PassContext& context) {
  FacadeWork around = work;
  around.stations = {}, around.steps = {}, around.recorded = false;
  around.before = around.behind = kDeep;
  std::vector<PassTask> tasks;
  for (const WallGroup& wall : walls) tasks.push_back({kBytes, points_to_read(around, wall)});
  std::vector<double> own(walls.size(), 0);
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const GatheredFacade gathered = gather_facade(around, walls[i]);
    own[i] = street_log_odds(side_evidence(sample_wall(gathered.site, gathered.points)));
  });
  std::vector<double> odds = own;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    odds[i] = storey_odds(walls, own, i, work.metres_per_unit);
    if (std::abs(odds[i]) >= kSure) continue;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      // A smaller plane beside a wall may be seen through its windows.
      if (k == i || walls[k].area_m2 < walls[i].area_m2 || !in_line(walls[i], walls[k], gap, work.metres_per_unit))
        continue;
      const double same = dot(walls[i].axes.out, walls[k].axes.out) > 0 ? 1 : -1;
      odds[i] += same * std::clamp(own[k], -kSure, kSure);
    }
  }
  return odds;
}

std::vector<double> segment_side_odds(std::span<const WallGroup> walls, std::span<const double> odds,
                                      std::span<const Segment> segments) {
  std::vector<double> by_segment(segments.size() + 1, 0);
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (const std::uint32_t id : walls[i].segments)
      by_segment[id] += dot(segments[id - 1].plane.n, walls[i].axes.out) > 0 ? odds[i] : -odds[i];
  return by_segment;
}

void turn_wall(WallGroup& wall, double metres_per_unit) {
  FacadeAxes& axes = wall.axes;
  axes.origin = axes.origin + (wall.width / metres_per_unit) * axes.right;
  axes.right = -1.0 * axes.right;
  axes.out = -1.0 * axes.out;
  for (SparsePart& part : wall.sparse) {
    const double u0 = wall.width - part.u1;
    part.u1 = wall.width - part.u0, part.u0 = u0;
    part.w0 = -part.w0, part.w1 = -part.w1;
    if (part.upright) std::swap(part.w0, part.w1);
  }
}

}  // namespace ilot
