// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/allocator.h"

#include <malloc.h>

#include <algorithm>

#include "engine/pass/resident.h"
#include "kernels/core/parallel.h"

namespace ilot {

void let_allocator_keep(std::uint64_t memory_bytes, int threads) {
  constexpr std::uint64_t kLeastRequest = 128u << 10, kMostRequest = 32u << 20;  // the upper limit of the C library
  const int working = affordable_threads(memory_bytes, threads > 0 ? threads : hardware_threads());
  const std::uint64_t request = memory_bytes / 32 / static_cast<std::uint64_t>(working);
  const auto kept = static_cast<int>(std::clamp(request, kLeastRequest, kMostRequest));
  mallopt(M_ARENA_MAX, static_cast<int>(allocator_pools(memory_bytes, working)));
  mallopt(M_MMAP_THRESHOLD, kept);
  mallopt(M_TRIM_THRESHOLD, 2 * kept);
}

}  // namespace ilot
