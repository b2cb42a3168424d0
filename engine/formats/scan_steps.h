// SPDX-License-Identifier: Apache-2.0
// The angular steps of a scanner, from the directions of the points that it measured.
#pragma once
#include <cstdint>
#include <span>

#include "kernels/core/types.h"

namespace ilot {

// Radians; 0 = unknown.
struct AngularSteps {
  double azimuth = 0, elevation = 0;
};

// A point of a scan seen from the scanner, which turns about z, with its place in the scan's grid.
struct GridPoint {
  std::int64_t row = 0, column = 0;
  Vec3 ray;  // of any length, not zero
};

// From pairs of points in one column or row, up to 16 places apart so that rounding of the coordinates counts little:
// medians of the angles between them over the places. Which of rows and columns turn about the axis shows in the
// angles. Both unknown where either is, or lies outside of 1e-6 to 0.087 rad (5 degrees). Points near the axis
// (12 degrees) are left out. O(n log n).
AngularSteps steps_of_grid(std::span<const GridPoint> points);

// The same from points in the order in which they were measured, profile after profile, without a grid: profiles end
// where the angle along them jumps back or turns round. Both unknown where the order is another.
AngularSteps steps_of_sequence(std::span<const Vec3> rays);

}  // namespace ilot
