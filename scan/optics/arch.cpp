// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/arch.h"

#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot::scan {
namespace {

constexpr double kSideRadius = 0.7;  // of the outer arcs of a basket arch, in shares of its rise

double half_width(const Opening& o) {
  return (o.right - o.left) / 2;
}

// Both arcs of a pointed arch have their centres on the springing line and meet at the crown.
double pointed_radius(double half, double rise) {
  return (half * half + rise * rise) / (2 * half);
}

// The middle arc of a basket arch touches the outer arcs, so the distance of their centres is the difference of their
// radii.
double basket_radius(double half, double rise) {
  const double side = kSideRadius * rise;
  return (half * half + rise * rise - 2 * half * side) / (2 * (rise - side));
}

bool within(double dx, double dy, double radius) {
  return dx * dx + dy * dy < radius * radius;
}

}  // namespace

std::vector<ArchArc> arcs_of(const Opening& o) {
  if (!(o.rise > 0)) return {};
  const double half = half_width(o), x = (o.left + o.right) / 2, z = o.springing;
  if (o.head == ArchHead::circular) {
    const double radius = arch_radius(o), below = radius - o.rise;
    const double from = direction_degrees(half, below);
    return {{{x, z + o.rise - radius}, radius, from > 180 ? from - 360 : from, from > 180 ? 540 - from : 180 - from}};
  }
  if (o.head == ArchHead::pointed) {
    const double radius = pointed_radius(half, o.rise), top = direction_degrees(radius - half, o.rise);
    return {{{x + half - radius, z}, radius, 0, top}, {{x - half + radius, z}, radius, 180 - top, 180}};
  }
  const double side = kSideRadius * o.rise, radius = basket_radius(half, o.rise);
  const double turn = direction_degrees(half - side, radius - o.rise);
  return {{{x + half - side, z}, side, 0, turn},
          {{x, z + o.rise - radius}, radius, turn, 180 - turn},
          {{x - half + side, z}, side, 180 - turn, 180}};
}

bool below_arch(const Opening& o, FlatPoint p) {
  const double half = half_width(o), dx = std::abs(p.x - (o.left + o.right) / 2), dz = p.y - o.springing;
  if (o.head == ArchHead::pointed) {
    const double radius = pointed_radius(half, o.rise);
    return within(dx - half + radius, dz, radius);
  }
  const double side = kSideRadius * o.rise, radius = basket_radius(half, o.rise);
  const double from_side = dx - (half - side), up = radius - o.rise;
  // Beyond the line through both centres the outer arc bounds the opening.
  if (from_side * up > dz * (half - side)) return within(from_side, dz, side);
  return within(dx, dz - o.rise + radius, radius);
}

}  // namespace ilot::scan
