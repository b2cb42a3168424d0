// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/core/types.h"
#include "kernels/shapes/shape.h"

namespace ilot {

// A sphere, cylinder or cone and what is known of the points that lie on it. Coordinates in the CRS of the inputs.
struct CurvedSegment {
  std::uint32_t id = 0;          // dense from 1 within a run
  std::uint64_t content_id = 0;  // of the set of points
  ShapeKind kind = ShapeKind::kSphere;
  std::uint64_t points = 0;
  Vec3 position;  // centre; of a cylinder the place on its axis nearest to the middle of the box; of a cone the apex
  Vec3 axis;      // of unit length; a cylinder's points up, a cone's into the cone; zero of a sphere
  double radius_m = 0;        // of spheres and cylinders
  double half_angle_deg = 0;  // of cones, between the axis and the surface
  double epsilon_m = 0;       // no point is farther
  double rms_m = 0;           // distance of the points from the surface
  Vec3 min, max;              // of the points
};

}  // namespace ilot
