// SPDX-License-Identifier: Apache-2.0
// The instruction sets of this machine beside the baseline: what tests of equal bits go through.
#pragma once
#include <vector>

#include "kernels/simd/dispatch.h"

namespace ilot::test {

inline std::vector<const simd::Table*> vector_tables() {
  std::vector<const simd::Table*> tables;
  for (const char* name : {"avx2", "avx512"})
    if (const simd::Table* t = simd::find_table(name)) tables.push_back(t);
  return tables;
}

}  // namespace ilot::test
