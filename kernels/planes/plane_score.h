// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "kernels/core/types.h"

namespace ilot {

// A hypothesis in the frame of the points it is tried on: a x + b y + c z + d, (a, b, c) of unit length.
using PlaneHypothesis = std::array<float, 4>;

struct PlaneScoreParams {
  float max_distance = 0;  // units of the points, inclusive
  float min_cos = 0;       // |normal . plane normal| at least this; ignored without normals
};

// counts[i] = points within max_distance of hypotheses[i] whose normal agrees, judged in float32. counts has the size
// of hypotheses. Many hypotheses at once are several times faster per plane than one: the points are read once per
// block. O(points x planes), no allocation. Same counts for every instruction set.
void count_inliers(const OrientedPoints& points, std::span<const PlaneHypothesis> hypotheses,
                   const PlaneScoreParams& params, std::span<std::uint32_t> counts);

}  // namespace ilot
