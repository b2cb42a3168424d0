// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

namespace ilot {

struct CirclePoint {
  double x = 0, y = 0;
};

struct Circle {
  double x = 0, y = 0, radius = 0;  // radius 0: none
};

// Fits a circle [Taubin 1991]: it is nearly unbiased for short arcs too. No circle for fewer than four points, or for
// points on a line. O(n).
Circle fit_circle(std::span<const CirclePoint> points);

}  // namespace ilot
