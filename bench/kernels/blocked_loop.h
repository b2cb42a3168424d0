// SPDX-License-Identifier: Apache-2.0
// What a good programmer writes in a few lines: the inliers of several planes, block by block, in float32 and structure
// of arrays, left to the compiler (-O3, fused operations, the widest registers of an instruction set).
#pragma once
#include <cstdint>
#include <span>

#include "kernels/planes/plane_score.h"

namespace ilot::bench {

// Counts the points within `distance` of each plane, compiled for the instruction set that the kernels use.
// counts.size() == planes.size().
void blocked_loop(Points points, std::span<const PlaneHypothesis> planes, float distance,
                  std::span<std::uint32_t> counts);

void blocked_loop_baseline(Points points, std::span<const PlaneHypothesis> planes, float distance,
                           std::span<std::uint32_t> counts);
void blocked_loop_avx2(Points points, std::span<const PlaneHypothesis> planes, float distance,
                       std::span<std::uint32_t> counts);
void blocked_loop_avx512(Points points, std::span<const PlaneHypothesis> planes, float distance,
                         std::span<std::uint32_t> counts);

}  // namespace ilot::bench
