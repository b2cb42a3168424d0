// SPDX-License-Identifier: Apache-2.0
// The memory of the whole process: the limit of a run and the free part of it. There is one value for the process,
// because its memory is common. It decides how many tasks run at once, never what they compute.
#pragma once
#include <cstdint>

namespace ilot {

// Sets the greatest number of resident bytes; 0 (the initial value) = no limit.
void set_memory_limit(std::uint64_t bytes);

// Returns the bytes that are not in use now; UINT64_MAX without a limit.
std::uint64_t free_memory();

// Returns the bytes that a step which is not a pass may use: its budget, or the free memory if that is less.
std::uint64_t affordable(std::uint64_t budget_bytes);

// Returns how many threads work under a limit of memory: as many as wanted, but at most one for each 24 MiB. Each
// thread takes some memory beside the budget: about 0.8 MiB was measured in the search for planes (stacks, buffers of
// inner loops, gaps of the allocator), so they take at most a thirtieth of the limit.
int affordable_threads(std::uint64_t memory_bytes, int wanted);

// Returns the number of pools of the allocator: one for each thread and one more, but no more than one for each 128
// MiB, because each pool keeps freed memory in its gaps.
std::uint64_t allocator_pools(std::uint64_t memory_bytes, int threads);

// When memory is scarce, returns to the system the freed memory that the allocator keeps between used memory. Called
// after a task of a pass has ended.
void close_gaps();

// Returns to the system the resident memory that is not needed now: freed memory that the allocator keeps, and pages of
// code that were read at the start (about 30 MiB of libraries). Costs some hundred page faults.
void trim_memory();

}  // namespace ilot
