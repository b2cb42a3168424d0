// SPDX-License-Identifier: Apache-2.0
#include "bench/ceiling/score_loop.h"
#include "kernels/simd/lanes_baseline.h"

namespace ilot::bench {
namespace {

using namespace simd::baseline;

inline void opaque(Wide& v) {
#if defined(__SSE2__)
  asm volatile("" : "+x"(v.lo), "+x"(v.hi));
#else
  asm volatile("" : : "r"(&v) : "memory");
#endif
}

#include "bench/ceiling/score_loop.inl"

}  // namespace

std::uint32_t score_loop_baseline(std::uint32_t rounds) {
  return loop(rounds);
}

}  // namespace ilot::bench
