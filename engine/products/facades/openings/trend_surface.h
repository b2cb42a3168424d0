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
// Leaves that cover most of a wall are the most frequent distance, but they end after the size of a window. The form is
// therefore also fitted to those points alone whose surface goes on over more than 3 m along the wall or upwards. It is
// taken where it lies behind the other one, by more than the least distance of leaves that can be distinguished from a
// wall, nowhere by more than leaves do, where it shows in each strip of 3 m of the wall, and where most of what stands
// before it does not go on so far: the wall of a house that stands farther out does. Not found where there are too few
// points. O(points).
TrendSurface trend_surface(const RaySamples& samples);

}  // namespace ilot
