// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/core/moments.h"

namespace ilot {

struct PlaneFit {
  Plane plane;          // in the frame and the units of the moments
  double rms = 0;       // root mean square distance of the points
  bool unique = false;  // false: fewer than three points, or all are on a line; the plane is then meaningless
};

// Fits the least-squares plane (orthogonal distances) of the points summed in m. The normal points up (z > 0, then y,
// then x).
PlaneFit fit_plane(const Moments& m);

// Returns the root mean square distance of the points summed in m (n > 0) to any plane in the same frame.
double rms_to_plane(const Moments& m, const Plane& plane);

// Returns the same plane after the anchor of the frame moves so that every coordinate grows by `by`.
Plane shifted(const Plane& plane, Vec3 by);

}  // namespace ilot
