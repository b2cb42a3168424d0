// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/core/types.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// Axes in a plane, and a lattice on the plane that is finer than that of space.
struct PlaneFrame {
  Vec3 origin;      // on the plane
  Vec3 u, v, n;     // right-handed, of unit length
  double step = 1;  // edge of the plane's lattice, in units of space
};

// Derived: a quarter of a step: rounding in the plane is below that of the points.
constexpr double kPlaneSteps = 4;  // lattice steps of the plane per unit of space

// Returns the frame of a plane near `anchor`, whose foot point is the origin. u is horizontal and v points up, so that
// facades appear upright, seen from the side to which the normal points. For planes within half a degree of horizontal,
// u points east. The frame depends on the plane and the anchor alone.
PlaneFrame frame_of(const Plane& plane, Vec3 anchor);

// Returns the foot point of p, rounded to the lattice of the plane. The bits are the same everywhere. p must be within
// kMaxPlaneCoordinate / kPlaneSteps of the origin.
Point2 project(const PlaneFrame& frame, Vec3 p);

// Returns the position in space of a point of the plane's lattice.
Vec3 position(const PlaneFrame& frame, Point2 p);

}  // namespace ilot
