// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "kernels/planes/plane_score.h"

namespace ilot {

struct FacadeDirection {
  Vec3 normal;         // horizontal unit vector across the facade; y > 0, or y = 0 and x > 0
  Vec3 along;          // horizontal unit vector along it
  double share = 0;    // of the points with a normal that face this way within 5 degrees
  bool found = false;  // false: no upright points; the vectors are then zero
};

// The direction that most of a cloud's upright surface faces. Estimator: normals within 20 degrees of the horizontal
// are counted by azimuth in 180 bins of a degree (a normal has no side); the window of five bins with most points wins
// (ties: the smaller azimuth); the answer is the mean of the normals within 5 degrees of its middle, taken over doubled
// angles so that opposite normals add up. No trigonometry of measured values, sums in order of points. O(n).
FacadeDirection facade_direction(const OrientedPoints& points);

}  // namespace ilot
