// SPDX-License-Identifier: Apache-2.0
// The only door to the thread library. Work is cut by the problem, never by the number of threads, so no result can
// depend on it: callers give a count of independent items, each of which writes its own slot.
#pragma once
#include <cstddef>
#include <functional>

namespace ilot {

// Runs body(i) for each i in [0, count), in any order, on the threads of the calling arena. The first exception thrown
// by a body stops the handing out of items and is rethrown here. A thread that waits inside a body does not start
// items of an outer loop (isolated), so memory that an outer item holds is never doubled.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

// Runs body inside an arena of exactly `threads` threads (at least 1). Every parallel_for below it uses that arena.
void with_threads(int threads, const std::function<void()>& body);

// Threads of the calling arena.
int thread_count();

// Number of hardware threads this process may use.
int hardware_threads();

}  // namespace ilot
