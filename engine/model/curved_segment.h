// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/core/types.h"
#include "kernels/shapes/shape.h"

namespace ilot {

// A sphere, cylinder or cone and the values known of the points on it. Coordinates are in the CRS of the inputs.
struct CurvedSegment {
  std::uint32_t id = 0;          // dense from 1 within a run
  std::uint64_t content_id = 0;  // computed from the set of points
  ShapeKind kind = ShapeKind::kSphere;
  std::uint64_t points = 0;
  Vec3 position;  // sphere: centre; cylinder: the place on its axis nearest to the middle of the box; cone: the apex
  Vec3 axis;      // unit length; cylinder: upwards; cone: into the cone; sphere: zero
  double radius_m = 0;        // of spheres and cylinders
  double half_angle_deg = 0;  // of cones, between the axis and the surface
  double epsilon_m = 0;       // greatest distance of a point
  double rms_m = 0;           // root mean square distance of the points from the surface
  Vec3 min, max;              // of the points
};

}  // namespace ilot
