// SPDX-License-Identifier: Apache-2.0
// Thresholds of a consensus set chosen from the points [Lorraine thesis, 2.3.2].
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"

namespace ilot {

// Where y(x) bends upwards most: the largest second derivative by divided differences, at an inner sample; ties to the
// first. x ascends. None with fewer than three samples, or where no bend is larger than `least_bend` times the mean
// slope over the whole range per range of x: a straight line has no knee.
std::optional<std::size_t> knee_of(std::span<const double> x, std::span<const double> y, double least_bend = 1);

struct ThresholdSweep {
  std::vector<double> value;  // thresholds tried
  std::vector<double>
      mse;  // mean squared distance of the consensus set of each, after refinement [Lorraine thesis, 2.2.2]
  double chosen = 0;
  bool found = false;  // false: `chosen` is the fallback
};

// delta, greatest distance: from twice the noise up to 6.5 cm in the document; the knee of MSE(delta), where the set
// starts to take in what is not the plane. No knee: three times the noise. `noise` in units; 19 thresholds from 2 to 11
// times it.
ThresholdSweep choose_distance(const OrientedPoints& points, std::span<const std::uint32_t> candidates,
                               const Plane& start, double noise, double min_cos);

// beta, greatest angle between normals in degrees: 10 to 75 in steps of 2.5; the least MSE(beta), ties to the wider
// angle. No consensus at any: 40, the document's value.
ThresholdSweep choose_angle(const OrientedPoints& points, std::span<const std::uint32_t> candidates, const Plane& start,
                            double epsilon);

}  // namespace ilot
