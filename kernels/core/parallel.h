// SPDX-License-Identifier: Apache-2.0
// This is the only access to the thread library. Work is divided by the problem and never by the number of threads, so
// no result depends on that number. Callers give a count of independent items, and each item writes its own slot.
#pragma once
#include <cstddef>
#include <functional>

namespace ilot {

// Runs body(i) for each i in [0, count), in any order, on the threads of the calling arena. When a body throws, no
// further items are started, and the first exception is rethrown here. A thread that waits inside a body does not start
// items of an outer loop (isolated), so the memory of an outer item is never needed twice.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

// Runs body inside an arena of exactly `threads` threads (at least 1). Every parallel_for inside body uses that arena.
void with_threads(int threads, const std::function<void()>& body);

// Returns the number of threads of the calling arena.
int thread_count();

// Returns the number of hardware threads that this process may use.
int hardware_threads();

}  // namespace ilot
