// SPDX-License-Identifier: Apache-2.0
// How far found planes lean and lie from the true ones they are matched with.
#pragma once
#include <span>

#include "engine/compare/plane_matching.h"
#include "engine/compare/truth.h"
#include "engine/model/segment.h"

namespace ilot {

struct ErrorSummary {
  double mean = 0, median = 0, largest = 0;
};

struct PlaneErrors {
  std::uint64_t planes = 0;  // matched pairs of which both equations are known
  ErrorSummary angle_deg;    // between the normals, either way round
  ErrorSummary offset_m;     // distance of the found plane's centroid from the true plane
};

// Of the matched pairs; those without an equation on either side are passed over. O((m + t + f) log).
PlaneErrors plane_errors(std::span<const PlaneMatch> matches, std::span<const TruePlane> truth,
                         std::span<const Segment> found, double metres_per_unit = 1);

}  // namespace ilot
