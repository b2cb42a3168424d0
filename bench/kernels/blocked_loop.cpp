// SPDX-License-Identifier: Apache-2.0
#include "bench/kernels/blocked_loop.h"

#include <cstring>

#include "kernels/simd/variants.h"

namespace ilot::bench {

void blocked_loop(Points points, std::span<const PlaneHypothesis> planes, float distance,
                  std::span<std::uint32_t> counts) {
#if ILOT_HAVE_X86_VARIANTS
  const char* isa = simd::name_of(simd::chosen_isa());
  if (std::strcmp(isa, "avx512") == 0) return blocked_loop_avx512(points, planes, distance, counts);
  if (std::strcmp(isa, "avx2") == 0) return blocked_loop_avx2(points, planes, distance, counts);
#endif
  blocked_loop_baseline(points, planes, distance, counts);
}

}  // namespace ilot::bench
