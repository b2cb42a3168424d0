// SPDX-License-Identifier: Apache-2.0
// How --memory is divided between the work, the blocks and the rest.
#pragma once
#include <cstdint>

#include "engine/run/options.h"

namespace ilot {

// Returns how much of --memory the work may use. The rest of 16 MiB, a sixth of 96M, is for memory that the estimates
// of the work do not include: the stacks of the threads and what the allocator keeps between blocks. At 96M, 16 threads
// were measured to take 4 MiB of it; with 12 MiB, two of four runs of a street of a million points were above 96M by
// 0.3 MiB.
std::uint64_t memory_to_fill(const RunOptions& options);

// Returns the part of --memory for blocks in work, without the program, its libraries and tables.
std::uint64_t memory_for_blocks(const RunOptions& options);

// Returns the largest number of points in a block that the memory budget allows, at most the setting.
std::uint64_t affordable_block_points(const RunOptions& options, int threads);

}  // namespace ilot
