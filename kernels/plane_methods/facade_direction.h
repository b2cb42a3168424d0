// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "kernels/planes/plane_score.h"

namespace ilot {

struct FacadeDirection {
  Vec3 normal;         // horizontal unit vector across the facade; y > 0, or y = 0 and x > 0
  Vec3 along;          // horizontal unit vector along the facade
  double share = 0;    // share of the points with a normal that face this way within 5 degrees
  bool found = false;  // false: there are no upright points, and the vectors are zero
};

// Estimates the direction that most of the upright surface of a cloud faces. Normals within 20 degrees of the
// horizontal are counted by azimuth in 180 bins of one degree (a normal has no sign). The window of five bins with most
// points wins (ties: the smaller azimuth). The result is the mean of the normals within 5 degrees of the middle of the
// window. The mean is taken over doubled angles so that opposite normals add up. No trigonometry is applied to measured
// values, and sums are in the order of points. O(n).
FacadeDirection facade_direction(const OrientedPoints& points);

}  // namespace ilot
