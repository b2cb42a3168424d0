// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

// Sets how much memory the allocator may keep for the next request. Memory that returns to the system must be cleared
// again by the system. The amount is a sixteenth of --memory, shared by the threads (0: all). A thread is served from
// pools up to half of its share. Larger requests go to the system, and leave no gaps.
void let_allocator_keep(std::uint64_t memory_bytes, int threads);

}  // namespace ilot
