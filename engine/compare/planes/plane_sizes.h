// SPDX-License-Identifier: Apache-2.0
// Counts which true planes were found, by size.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "engine/compare/planes/plane_matching.h"
#include "engine/compare/truth.h"

namespace ilot {

// A class of true planes by area in square metres. It ends where the class before begins.
struct PlaneSizeClass {
  double from_m2 = 0;
  std::uint64_t truth = 0, matched = 0;
};
using PlaneSizes = std::array<PlaneSizeClass, 4>;

// The area of a true plane's polygons without their holes, in squared units of its coordinates; 0 without polygons.
double area_of(const TruePlane& plane);

// Counts the true planes that are judged (empty: all) and have polygons. O((m + t) log m).
PlaneSizes plane_sizes(std::span<const PlaneMatch> matches, std::span<const TruePlane> truth,
                       const std::function<bool(std::uint32_t)>& judged, double metres_per_unit = 1);

}  // namespace ilot
