// SPDX-License-Identifier: Apache-2.0
// The memory of the process as a whole: what a run was allowed, and what is left of it. One value for the process, as
// its memory is one; it decides how many tasks run at once, never what they compute.
#pragma once
#include <cstdint>

namespace ilot {

// Most bytes that should be resident; 0 (as at the start) = no limit.
void set_memory_limit(std::uint64_t bytes);

// How many of the bytes are not in use now; UINT64_MAX without a limit.
std::uint64_t free_memory();

// Bytes that a step which is no pass may take: its budget, or what of the memory is left.
std::uint64_t affordable(std::uint64_t budget_bytes);

// Into how many pools the allocator divides its memory: one a thread and one more, but no more than one for each 128
// MiB, as each keeps freed memory in its gaps.
std::uint64_t allocator_pools(std::uint64_t memory_bytes, int threads);

// Where memory is tight, gives back what the allocator keeps of freed memory between what is in use. To be called when
// a task of a pass has ended.
void close_gaps();

// Gives back to the system what of the resident memory is not needed now: what the allocator keeps of freed memory, and
// pages of code that were read to start (about 30 MiB of libraries). Costs some hundred page faults.
void trim_memory();

}  // namespace ilot
