// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_ends.h"

#include <algorithm>
#include <cmath>

#include "engine/products/facades/walls/wall_neighbours.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Moves the ends of two walls, the second one on the right of the first one.
void part(WallGroup& a, WallGroup& b, const WallParams& params) {
  const double metres = params.metres_per_unit;
  if (dot(a.axes.out, b.axes.out) < cos_degrees(kTurnInRowDeg)) return;
  const Vec3 d = metres * (b.axes.origin - a.axes.origin);
  const double shift = dot(d, a.axes.right), off = dot(d, a.axes.out), low = dot(d, a.axes.up);
  const double common_height = std::min(a.height, low + b.height) - std::max(0.0, low);
  if (std::abs(off) > params.relief_front || common_height < params.least_height) return;
  const double core_a = a.core1, core_b = shift + b.core0;
  if (a.core0 >= core_b || core_a >= shift + b.core1 || core_a - core_b > kCommonByChance) return;
  double end_a = a.width, begin_b = shift;
  if (core_a > core_b) {
    const double middle = (core_a + core_b) / 2;
    end_a = std::min(end_a, middle), begin_b = std::max(begin_b, middle);
  } else {
    end_a = std::min(end_a, core_b), begin_b = std::max(begin_b, core_a);
    if (end_a > begin_b) end_a = begin_b = (end_a + begin_b) / 2;
  }
  a.width = end_a, a.core1 = std::min(a.core1, end_a);
  const double by = begin_b - shift;
  b.axes.origin = b.axes.origin + (by / metres) * b.axes.right;
  b.width -= by, b.core0 = std::max(0.0, b.core0 - by), b.core1 -= by;
}

}  // namespace

void end_at_neighbours(std::vector<WallGroup>& walls, const WallParams& params) {
  for_each_near_wall(walls, 0, params, [&](std::size_t i, std::size_t k) { part(walls[i], walls[k], params); });
}

}  // namespace ilot
