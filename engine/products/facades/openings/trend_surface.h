// SPDX-License-Identifier: Apache-2.0
// How a wall bows and leans out of its mean plane, and how its points scatter about that form.
#pragma once
#include <array>

#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// A trend surface: a polynomial of the second degree in the place on the wall.
struct TrendSurface {
  bool found = false;
  double noise = 0;  // metres: standard deviation of the points of the wall about the form
  double width = 1, height = 1;
  std::array<double, 6> terms{};

  double at(double u, double v) const {
    const double x = u / width - 0.5, y = v / height - 0.5;
    return terms[0] + terms[1] * x + terms[2] * y + terms[3] * x * x + terms[4] * x * y + terms[5] * y * y;
  }
};

// Fits the form by least squares, in several rounds, each with the points near the most frequent distance from the form
// of the round before: panes and joints lie behind the wall, and only what lies before that distance gives the scatter.
// Not found where there are too few points. O(points).
TrendSurface trend_surface(const RaySamples& samples);

}  // namespace ilot
