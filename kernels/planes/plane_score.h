// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "kernels/core/types.h"

namespace ilot {

// A hypothesis in the frame of the points: a x + b y + c z + d, with (a, b, c) of unit length.
using PlaneHypothesis = std::array<float, 4>;

struct PlaneScoreParams {
  float max_distance = 0;  // units of the points, inclusive
  float min_cos = 0;       // |normal . plane normal| at least this; ignored without normals
};

// Sets counts[i] to the number of points within max_distance of hypotheses[i] whose normal agrees, judged in float32
// with fused operations, each rounded once (good to two units in the last place of the largest term). counts has the
// size of hypotheses. Many hypotheses in one call are several times faster per plane than one, because the points are
// read once per block. O(points x planes), no allocation. The counts are the same for every instruction set.
void count_inliers(const OrientedPoints& points, std::span<const PlaneHypothesis> hypotheses,
                   const PlaneScoreParams& params, std::span<std::uint32_t> counts);

}  // namespace ilot
