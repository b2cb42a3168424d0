// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/pose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot::scan {
namespace {

double reach_along(const PlanBox& box, FlatPoint axis) {
  const double along = box.heading.cos * axis.x + box.heading.sin * axis.y;
  const double across = box.heading.cos * axis.y - box.heading.sin * axis.x;
  return box.half_length * std::abs(along) + box.half_width * std::abs(across);
}

}  // namespace

Vec3 Pose::direction(Vec3 local) const {
  const Vec3 up{pitch.cos * local.x - pitch.sin * local.z, local.y, pitch.sin * local.x + pitch.cos * local.z};
  return {up.x * heading.cos - up.y * heading.sin, up.x * heading.sin + up.y * heading.cos, up.z};
}

Solid placed(const Solid& solid, const Pose& pose) {
  Solid moved = solid;
  for (std::uint32_t i = 0; i < solid.plane_count; ++i) {
    const Vec3 n = pose.direction(solid.planes[i].n);
    moved.planes[i] = {n, solid.planes[i].d - dot(n, pose.base)};
  }
  moved.quadric.point = pose.place(solid.quadric.point);
  moved.quadric.axis = pose.direction(solid.quadric.axis);
  const Box3<Vec3>& box = solid.bounds;
  const Vec3 first = pose.place(box.min);
  moved.bounds = {first, first};
  for (double x : {box.min.x, box.max.x})
    for (double y : {box.min.y, box.max.y})
      for (double z : {box.min.z, box.max.z}) moved.bounds.add(pose.place({x, y, z}));
  return moved;
}

bool closer(const PlanBox& a, const PlanBox& b, double apart) {
  const FlatPoint between{b.x - a.x, b.y - a.y};
  const std::array<FlatPoint, 4> axes{{{a.heading.cos, a.heading.sin},
                                       {-a.heading.sin, a.heading.cos},
                                       {b.heading.cos, b.heading.sin},
                                       {-b.heading.sin, b.heading.cos}}};
  return std::all_of(axes.begin(), axes.end(), [&](FlatPoint axis) {
    const double distance = std::abs(between.x * axis.x + between.y * axis.y);
    return distance - reach_along(a, axis) - reach_along(b, axis) < apart;
  });
}

}  // namespace ilot::scan
