// SPDX-License-Identifier: Apache-2.0
// The place on a line where the density of points changes.
#pragma once
#include <cstddef>
#include <span>

namespace ilot {

struct DensityStep {
  double at = 0;                // the most likely place
  double low = 0, high = 0;     // the true place is between these in 95 of 100 cases
  double below = 0, above = 0;  // points per unit of length on both sides of `at`
  double likelihood = 0;        // natural logarithm: over that of one density everywhere
  bool found = false;
};

// Finds the place in [from, to] at which two densities are most likely that made these points, where there are more
// above it and points fall independently of each other on both sides (Akman and Raftery 1986). It is at a point, as the
// likelihood rises up to the first point of the denser side; none in the outer twentieths of the range is looked at.
// Points in lines, as those of a scan, are not independent: the step is then at the first line of the denser side, and
// the true place up to a line before it. `places` are ascending and in the range; any unit. O(n).
DensityStep density_step(std::span<const double> places, double from, double to);

}  // namespace ilot
