// SPDX-License-Identifier: Apache-2.0
// Steps of a surface along straight lines.
#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace ilot {

constexpr std::size_t kStepStrips = 32;      // across a window
constexpr std::size_t kStepDirections = 16;  // at once, at most

struct StepDirection {
  double x = 1, y = 0;  // unit vector
};

// The inverse of the matrix of the normal equations of a plane z = a + b x + c y: rows a b c, b d e, c e f.
struct PlaneInverse {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;
};

// Points around (0, 0), at most `radius` from it, and the plane of least squares through them all.
struct StepWindow {
  std::span<const double> x, y;
  std::span<const double> residual;  // z less the plane
  double radius = 1;
  PlaneInverse inverse;
  double least_points = 1;  // of each side of a line
};

// For each direction the lines across it that part the strips, kStepStrips values each: value b is of the line between
// strips b - 1 and b, at b / kStepStrips * 2 radius - radius along the direction. Value 0 is of no line.
struct StepGains {
  std::array<double, kStepDirections * kStepStrips> gain;      // 0 = a side has too few points, or strip b none
  std::array<double, kStepDirections * kStepStrips> residual;  // sum over strips b and beyond
};

// How much less the sum of the squared residuals is where the plane has a step along the line: by the Schur complement
// of the step's height, s^2 / (n - v' M v) for n points beyond the line, with the sums v of their (1, x, y), s of their
// residuals, and the inverse M. O(points * directions). The same bits with every instruction set.
void step_gains(const StepWindow& window, std::span<const StepDirection> directions, StepGains& out);

}  // namespace ilot
