// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_parts.h"

#include <algorithm>
#include <cmath>

#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// Derived: a majority.
constexpr double kAlongside = 0.5;  // share of the width of a plane
// Derived: a majority; scraps that lie in the plane of a wall by chance are lower.
constexpr double kMostOfHeight = 0.5;  // share of the height of a plane

// Whether the wall steps back or forth between two segments, seen at the ends that are nearest to each other. Half of
// the way between them follows the one, half the other.
bool steps_between(const SegmentEnds& a, const SegmentEnds& b, const WallParams& params) {
  // Derived: three standard deviations.
  constexpr double kSure = 3;
  if (!a.known || !b.known) return false;
  // Choice: the place of a step is known better; beyond half a metre another end may be meant.
  constexpr double kSamePlace = 0.5;  // metres
  double nearest = INFINITY, step = 0, error = 0, height = 0;
  bool known = false;  // that there is a step
  for (const EndPlane* p : {&a.left, &a.right})
    for (const EndPlane* q : {&b.left, &b.right}) {
      const double along = norm(FlatPoint{q->place.x - p->place.x, q->place.y - p->place.y});
      if (!(along < nearest)) continue;
      const Vec3 sum = p->normal + (dot(p->normal, q->normal) > 0 ? 1.0 : -1.0) * q->normal;
      nearest = along;
      known = (p->step || q->step) && along * params.metres_per_unit <= kSamePlace;
      step = std::abs(dot(q->place - p->place, sum)) / norm(sum) * params.metres_per_unit;
      error = kSure * norm(FlatPoint{p->error_m, q->error_m});
      height = (p->height_m + q->height_m) / 2 - std::abs(q->place.z - p->place.z) * params.metres_per_unit;
    }
  // Storeys that are set back lie above each other, not beside each other.
  return height >= params.least_height && (known || step - error >= params.least_step);
}

double apart_from(const WallExtent& e, const KnownPart& part) {
  return std::max(e.u0 - part.box.u1, part.box.u0 - e.u1);
}

}  // namespace

bool is_far(const WallExtent& e, std::span<const KnownPart> parts, double gap) {
  return std::all_of(parts.begin(), parts.end(), [&](const KnownPart& part) { return apart_from(e, part) > gap; });
}

bool steps_off(const WallExtent& e, std::size_t index, std::span<const KnownPart> parts,
               std::span<const SegmentEnds> ends, const WallParams& params) {
  const KnownPart* nearest = nullptr;
  double least = INFINITY;
  for (const KnownPart& part : parts) {
    const double apart = apart_from(e, part);
    if (part.known && apart < least) least = apart, nearest = &part;
  }
  if (nearest == nullptr) return false;
  const double common = -least, narrower = std::min(e.u1 - e.u0, nearest->box.u1 - nearest->box.u0);
  return common < kAlongside * narrower && steps_between(ends[nearest->index], ends[index], params);
}

bool are_along(const WallExtent& e, std::span<const KnownPart> parts) {
  double height = 0;
  for (const KnownPart& part : parts)
    if (std::min(part.box.u1, e.u1) - std::max(part.box.u0, e.u0) >= kAlongside * (e.u1 - e.u0))
      height += std::max(0.0, std::min(part.box.v1, e.v1) - std::max(part.box.v0, e.v0));
  return height >= kMostOfHeight * (e.v1 - e.v0);
}

bool is_beside(const WallExtent& e, const Segment& s, std::span<const KnownPart> parts, const WallParams& params) {
  const double width = e.u1 - e.u0;
  if (s.area_m2 < params.least_area || width < params.least_width || e.v1 - e.v0 < params.least_height) return false;
  if (are_along(e, parts)) return false;
  double from = e.u0, to = e.u1;  // the stretch without a part, from the parts on both sides
  bool left = false, right = false;
  for (const KnownPart& part : parts) {
    if (!part.wide) continue;
    if (std::min(part.box.u1, e.u1) - std::max(part.box.u0, e.u0) >= kAlongside * width) return false;
    if (part.box.u0 + part.box.u1 < e.u0 + e.u1) {
      from = left ? std::max(from, part.box.u1) : part.box.u1;
      left = true;
    } else {
      to = right ? std::min(to, part.box.u0) : part.box.u0;
      right = true;
    }
  }
  return !(left && right) || to - from > params.gap;
}

}  // namespace ilot
