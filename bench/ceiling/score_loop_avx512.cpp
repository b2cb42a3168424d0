// SPDX-License-Identifier: Apache-2.0
#include "bench/ceiling/score_loop.h"
#include "kernels/simd/lanes_avx512.h"

namespace ilot::bench {
namespace {

using namespace simd::avx512;

inline void opaque(Wide& v) {
  asm volatile("" : "+v"(v.v));
}

#include "bench/ceiling/score_loop.inl"

}  // namespace

std::uint32_t score_loop_avx512(std::uint32_t rounds) {
  return loop(rounds);
}

}  // namespace ilot::bench
