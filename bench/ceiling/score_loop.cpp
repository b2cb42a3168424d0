// SPDX-License-Identifier: Apache-2.0
#include "bench/ceiling/score_loop.h"

#include <cstring>
#include <vector>

#include "kernels/core/parallel.h"
#include "kernels/simd/variants.h"

namespace ilot::bench {
namespace {

struct Loop {
  std::uint32_t (*run)(std::uint32_t);
  double width;  // points in a register
};

Loop loop_of_this_machine() {
#if ILOT_HAVE_X86_VARIANTS
  if (std::strcmp(simd::name_of(simd::chosen_isa()), "avx512") == 0) return {score_loop_avx512, 16};
  if (std::strcmp(simd::name_of(simd::chosen_isa()), "avx2") == 0) return {score_loop_avx2, 8};
#endif
  return {score_loop_baseline, 8};
}

}  // namespace

void score_loop(double point_planes) {
  constexpr std::size_t kParts = 16;
  constexpr int kPlanes = 4;
  const Loop loop = loop_of_this_machine();
  const auto rounds = static_cast<std::uint32_t>(point_planes / (kParts * kPlanes * loop.width));
  std::vector<std::uint32_t> counts(kParts);
  parallel_for(kParts, [&](std::size_t i) { counts[i] = loop.run(rounds); });
}

}  // namespace ilot::bench
