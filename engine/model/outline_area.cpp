// SPDX-License-Identifier: Apache-2.0
#include "engine/model/outline_area.h"

namespace ilot {
namespace {

double area_of(const Outline::Ring& ring) {
  Vec3 sum;
  for (std::size_t i = 2; i < ring.size(); ++i) sum = sum + cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  return norm(sum) / 2;
}

}  // namespace

double area_of(const Outline& outline) {
  double area = 0;
  for (const Outline::Part& part : outline.parts)
    for (std::size_t r = 0; r < part.size(); ++r) area += r == 0 ? area_of(part[r]) : -area_of(part[r]);
  return area;
}

}  // namespace ilot
