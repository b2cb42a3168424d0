// SPDX-License-Identifier: Apache-2.0
// Measures the angles and offsets between found planes and the true planes with which they are matched.
#pragma once
#include <span>

#include "engine/compare/planes/plane_matching.h"
#include "engine/compare/truth.h"
#include "engine/model/segment.h"

namespace ilot {

struct ErrorSummary {
  double mean = 0, median = 0, largest = 0;
};

struct PlaneErrors {
  std::uint64_t planes = 0;  // matched pairs with both equations known
  ErrorSummary angle_deg;    // between the normals without regard to their sign
  ErrorSummary offset_m;     // distance of the found plane's centroid from the true plane
};

// Computes the errors of the matched pairs. Pairs without an equation on either side are skipped. O((m + t + f) log).
PlaneErrors plane_errors(std::span<const PlaneMatch> matches, std::span<const TruePlane> truth,
                         std::span<const Segment> found, double metres_per_unit = 1);

}  // namespace ilot
