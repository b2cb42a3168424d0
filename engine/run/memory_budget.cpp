// SPDX-License-Identifier: Apache-2.0
#include "engine/run/memory_budget.h"

#include <algorithm>

#include "engine/pass/resident.h"
#include "kernels/core/parallel.h"

namespace ilot {

std::uint64_t memory_to_fill(const RunOptions& options) {
  constexpr std::uint64_t kLeftOut = 16u << 20;
  return options.memory_bytes - std::min(options.memory_bytes / 2, kLeftOut);
}

std::uint64_t memory_for_blocks(const RunOptions& options) {
  constexpr std::uint64_t kBase = 56u << 20;
  constexpr std::uint64_t kGaps =
      6;  // one part in this number: measured with 16 threads and 4 pools, a fifth of the used memory
  const std::uint64_t gaps =
      allocator_pools(options.memory_bytes, thread_count()) > 1 ? options.memory_bytes / kGaps : 0;
  return std::max(options.memory_bytes, 2 * kBase) - kBase - gaps;
}

std::uint64_t affordable_block_points(const RunOptions& options, int threads) {
  constexpr std::uint64_t kPerPoint = 96;  // of a block in work, with its surroundings
  constexpr std::uint64_t kLeast = 1u << 14;
  const std::uint64_t affordable = memory_for_blocks(options) / (kPerPoint * static_cast<std::uint64_t>(threads));
  return std::min(options.settings.index.block_points, std::max(kLeast, affordable));
}

}  // namespace ilot
