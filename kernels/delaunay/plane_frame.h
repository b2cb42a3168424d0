// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/core/types.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// Axes in a plane, and a lattice on it that is finer than that of space.
struct PlaneFrame {
  Vec3 origin;      // on the plane
  Vec3 u, v, n;     // right-handed, of unit length
  double step = 1;  // edge of the plane's lattice, in units of space
};

constexpr double kPlaneSteps = 4;  // steps of the plane's lattice a unit of space

// The frame of a plane near `anchor`, whose foot point is the origin. u is horizontal and v points up, so that facades
// are seen as they stand, from the side the normal points to; for planes within half a degree of level u points east.
// Depends on the plane and the anchor alone.
PlaneFrame frame_of(const Plane& plane, Vec3 anchor);

// Foot point of p, rounded to the plane's lattice: the same bits wherever it is asked. p lies within
// kMaxPlaneCoordinate / kPlaneSteps of the origin.
Point2 project(const PlaneFrame& frame, Vec3 p);

// Where a point of the plane's lattice lies in space.
Vec3 position(const PlaneFrame& frame, Point2 p);

}  // namespace ilot
