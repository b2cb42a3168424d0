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

constexpr std::size_t kFitPoints = 4096;  // curved shapes are fitted to at most about this many points, evenly spread

// Fits a shape by least squares of distances, from a start near by. Planes are fitted exactly by their moments. Curved
// shapes are fitted by at most 30 damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963) in double, with sums in
// the order of the indices. Offsets are integers below 2^22. O(iterations x min(n, 2 kFitPoints)).
ShapeFit fit_shape(Points points, std::span<const std::uint32_t> indices, const Shape& start);

}  // namespace ilot
