// SPDX-License-Identifier: Apache-2.0
// The circle through points of an arc.
#pragma once
#include <span>

namespace ilot {

struct PlanePoint {
  double x = 0, y = 0;
};

struct CircleFit {
  PlanePoint centre;
  double radius = 0;
  double rms = 0;  // of the points' distances from the circle
  bool found = false;
};

// Fits by least squares of the distances (Gauss and Newton, starting from the algebraic fit of Kasa 1976). No circle is
// found for fewer than three points or for points on a line. The result is meaningful where the height of the arc is
// several times the noise. O(n).
CircleFit fit_circle(std::span<const PlanePoint> points);

}  // namespace ilot
