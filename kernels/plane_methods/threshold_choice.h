// SPDX-License-Identifier: Apache-2.0
// Chooses the thresholds of a consensus set from the points [Lorraine thesis, 2.3.2].
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"

namespace ilot {

// Returns the knee, where y(x) bends upwards most: the inner sample with the largest second derivative by divided
// differences (ties: the first). x is ascending. The result is empty with fewer than three samples. It is empty too
// where no bend is larger than `least_bend` times the mean slope over the whole range per range of x, because a
// straight line has no knee.
std::optional<std::size_t> knee_of(std::span<const double> x, std::span<const double> y, double least_bend = 1);

struct ThresholdSweep {
  std::vector<double> value;  // thresholds tried
  std::vector<double>
      mse;  // mean squared distance of the consensus set of each, after refinement [Lorraine thesis, 2.2.2]
  double chosen = 0;
  bool found = false;  // false: `chosen` is the fallback
};

// Chooses delta, the greatest distance. The document tries values from twice the noise up to 6.5 cm. The choice is the
// knee of MSE(delta), where the set starts to include points that are not of the plane. Without a knee it is three
// times the noise. `noise` is in units. There are 19 thresholds from 2 to 11 times the noise.
ThresholdSweep choose_distance(const OrientedPoints& points, std::span<const std::uint32_t> candidates,
                               const Plane& start, double noise, double min_cos);

// Chooses beta, the greatest angle between normals, in degrees: 10 to 75 in steps of 2.5. The choice has the least
// MSE(beta) (ties: the wider angle). Without a consensus set at any angle it is 40, the value of the document.
ThresholdSweep choose_angle(const OrientedPoints& points, std::span<const std::uint32_t> candidates, const Plane& start,
                            double epsilon);

}  // namespace ilot
