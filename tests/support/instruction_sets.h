// SPDX-License-Identifier: Apache-2.0
// The instruction sets of this machine in addition to the baseline. Tests for equal bits run with each of them.
#pragma once
#include <vector>

#include "kernels/simd/variants.h"

namespace ilot::test {

inline std::vector<simd::Isa> vector_isas() {
  std::vector<simd::Isa> isas;
  for (const simd::Isa isa : {simd::Isa::avx2, simd::Isa::avx512})
    if (simd::has_isa(isa)) isas.push_back(isa);
  return isas;
}

}  // namespace ilot::test
