// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/plane_frame.h"

#include <cmath>

namespace ilot {

PlaneFrame frame_of(const Plane& plane, Vec3 anchor) {
  // Derived: the comment on the line.
  constexpr double kLevel = 1e-4;  // squared sine of about half a degree
  PlaneFrame frame;
  frame.n = plane.n;
  frame.origin = anchor - signed_distance(plane, anchor) * plane.n;
  const double slope2 = plane.n.x * plane.n.x + plane.n.y * plane.n.y;
  const Vec3 along = slope2 < kLevel ? cross({0, 1, 0}, plane.n) : Vec3{-plane.n.y, plane.n.x, 0};
  frame.u = (1 / norm(along)) * along;
  frame.v = cross(frame.n, frame.u);
  frame.step = 1 / kPlaneSteps;
  return frame;
}

Point2 project(const PlaneFrame& frame, Vec3 p) {
  const Vec3 d = p - frame.origin;
  return {static_cast<std::int32_t>(std::floor(dot(d, frame.u) * kPlaneSteps + 0.5)),
          static_cast<std::int32_t>(std::floor(dot(d, frame.v) * kPlaneSteps + 0.5))};
}

Vec3 position(const PlaneFrame& frame, Point2 p) {
  return frame.origin + frame.step * p.x * frame.u + frame.step * p.y * frame.v;
}

}  // namespace ilot
