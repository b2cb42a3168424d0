// SPDX-License-Identifier: Apache-2.0
// The angular steps of a scanner, estimated from the directions of the measured points.
#pragma once
#include <cstdint>
#include <span>

#include "kernels/core/types.h"

namespace ilot {

// Radians; 0 = unknown.
struct AngularSteps {
  double azimuth = 0, elevation = 0;
};

// A point of a scan relative to the scanner, which rotates about z, with its place in the grid of the scan.
struct GridPoint {
  std::int64_t row = 0, column = 0;
  Vec3 ray;  // of any length, not zero
};

// Uses pairs of points in one column or row, up to 16 places apart so that rounding of the coordinates has little
// effect. The steps are the medians of the angles between them divided by the number of places. The angles show whether
// rows or columns rotate about the axis. Both steps are unknown when one is unknown or outside 1e-6 to 0.087 rad (5
// degrees). Points near the axis (12 degrees) are left out. O(n log n).
AngularSteps steps_of_grid(std::span<const GridPoint> points);

// The same for points in the order of measurement, profile after profile, without a grid. A profile ends where the
// angle along it jumps back or changes direction. Both steps are unknown when the points have another order.
AngularSteps steps_of_sequence(std::span<const Vec3> rays);

}  // namespace ilot
