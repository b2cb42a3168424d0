// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot {

// A plane and what is known of the points that lie on it. Coordinates in the CRS of the inputs.
struct Segment {
  std::uint32_t id = 0;          // dense from 1 within a run
  std::uint64_t content_id = 0;  // of the set of points: equal in every run that finds the same points
  Plane plane;                   // world coordinates and CRS units; unit normal, pointing up
  std::uint64_t points = 0;
  Vec3 centroid;
  Vec3 min, max;         // of the points
  double rms_m = 0;      // distance of the points from the plane
  double epsilon_m = 0;  // none is farther
};

}  // namespace ilot
