// SPDX-License-Identifier: Apache-2.0
#include "kernels/simd/variants.h"

#include <cstdlib>
#include <cstring>
#include <initializer_list>

namespace ilot::simd {
namespace {

Isa choose() {
  const char* forced = std::getenv("ILOT_FORCE_ISA");
  for (const Isa isa : {Isa::avx512, Isa::avx2})
    if (has_isa(isa) && (forced == nullptr || *forced == '\0' || std::strcmp(forced, name_of(isa)) == 0)) return isa;
  return Isa::baseline;
}

}  // namespace

const char* name_of(Isa isa) {
  constexpr const char* kNames[] = {"baseline", "avx2", "avx512"};
  return kNames[static_cast<int>(isa)];
}

bool has_isa(Isa isa) {
#if ILOT_HAVE_X86_VARIANTS
  if (isa == Isa::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (isa == Isa::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#endif
  return isa == Isa::baseline;
}

Isa chosen_isa() {
  static const Isa chosen = choose();
  return chosen;
}

}  // namespace ilot::simd
