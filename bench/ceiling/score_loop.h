// SPDX-License-Identifier: Apache-2.0
// The ceiling of arithmetic: multiplications, additions, comparisons and counts in the proportion of plane scoring, on
// registers alone, with the lanes of the instruction set that the kernels use. No fused operations: the kernels may not
// use them either, or their bits would differ between classifiers.
#pragma once
#include <cstddef>
#include <cstdint>

namespace ilot::bench {

// Does as much arithmetic as so many point-planes cost, in 16 independent parts on the threads of the calling arena.
void score_loop(double point_planes);

// One part per instruction set: `rounds` times four planes on as many points as its registers hold. Returns the counts,
// so that nothing is left out.
std::uint32_t score_loop_baseline(std::uint32_t rounds);
std::uint32_t score_loop_avx2(std::uint32_t rounds);
std::uint32_t score_loop_avx512(std::uint32_t rounds);

}  // namespace ilot::bench
