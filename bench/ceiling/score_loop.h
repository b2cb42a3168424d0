// SPDX-License-Identifier: Apache-2.0
// The ceiling of arithmetic: fused multiplications and additions, tests and counts in the same proportion as in plane
// scoring. It works on registers alone, with the lanes of the instruction set that the kernels use.
#pragma once
#include <cstddef>
#include <cstdint>

namespace ilot::bench {

// Does as much arithmetic as `point_planes` pairs of point and plane need, in 16 independent parts on the threads of
// the calling arena.
void score_loop(double point_planes);

// Does one part with one instruction set: `rounds` times four planes on as many points as its registers contain.
// Returns the counts, so that the compiler cannot remove any work.
std::uint32_t score_loop_baseline(std::uint32_t rounds);
std::uint32_t score_loop_avx2(std::uint32_t rounds);
std::uint32_t score_loop_avx512(std::uint32_t rounds);

}  // namespace ilot::bench
