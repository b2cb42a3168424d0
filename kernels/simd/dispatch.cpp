// SPDX-License-Identifier: Apache-2.0
#include "kernels/simd/dispatch.h"

#include <cstdlib>
#include <cstring>

namespace ilot::simd {

namespace baseline {
extern const Table kTable;
}
#if ILOT_HAVE_AVX2
namespace avx2 {
extern const Table kTable;
}
#endif

const Table* find_table(const char* name) {
  if (std::strcmp(name, "baseline") == 0) return &baseline::kTable;
#if ILOT_HAVE_AVX2
  if (std::strcmp(name, "avx2") == 0 && __builtin_cpu_supports("avx2")) return &avx2::kTable;
#endif
  return nullptr;
}

const Table& table() {
  static const Table& chosen = [&]() -> const Table& {
    const char* forced = std::getenv("ILOT_FORCE_ISA");
    const Table* found = find_table(forced != nullptr ? forced : "avx2");
    return found != nullptr ? *found : baseline::kTable;
  }();
  return chosen;
}

}  // namespace ilot::simd
