// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/shapes/shape.h"

namespace ilot {

struct ShapeFit {
  Shape shape;
  double rms = 0;      // root mean square distance of the points used
  int iterations = 0;  // accepted steps
  bool valid = false;  // false: too few points, or they do not determine the shape; `shape` is then the start
};

constexpr std::size_t kFitPoints = 4096;  // curved shapes are fitted to at most about so many, evenly spread

// Least-squares fit of distances, from a start near by: planes by their moments, exactly; curved shapes by damped
// Gauss-Newton steps (Levenberg 1944, Marquardt 1963) in double with sums in the order of the indices, at most 30.
// Offsets are integers below 2^22. O(iterations x min(n, 2 kFitPoints)).
ShapeFit fit_shape(Points points, std::span<const std::uint32_t> indices, const Shape& start);

}  // namespace ilot
