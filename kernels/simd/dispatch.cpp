// SPDX-License-Identifier: Apache-2.0
#include "kernels/simd/dispatch.h"

#include <cstdlib>
#include <cstring>

namespace ilot::simd {

namespace baseline {
extern const Table kTable;
}
#if ILOT_HAVE_X86_VARIANTS
namespace avx2 {
extern const Table kTable;
}
namespace avx512 {
extern const Table kTable;
}
#endif

const Table* find_table(const char* name) {
  if (std::strcmp(name, "baseline") == 0) return &baseline::kTable;
#if ILOT_HAVE_X86_VARIANTS
  if (std::strcmp(name, "avx2") == 0 && __builtin_cpu_supports("avx2")) return &avx2::kTable;
  const bool has_512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                       __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  if (std::strcmp(name, "avx512") == 0 && has_512) return &avx512::kTable;
#endif
  return nullptr;
}

const Table& table() {
  static const Table& chosen = [&]() -> const Table& {
    const char* forced = std::getenv("ILOT_FORCE_ISA");
    const char* const best_first[] = {"avx512", "avx2"};
    for (const char* name : best_first) {
      const Table* found = find_table(forced != nullptr ? forced : name);
      if (found != nullptr) return *found;
    }
    return baseline::kTable;
  }();
  return chosen;
}

}  // namespace ilot::simd
