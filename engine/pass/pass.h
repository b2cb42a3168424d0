// SPDX-License-Identifier: Apache-2.0
// Runs the independent tasks of one stage on all threads, within a budget of memory.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

namespace ilot {

struct PassTask {
  std::uint64_t bytes = 0;   // estimate of the memory that it holds while it runs
  std::uint64_t points = 0;  // for ordering: the largest start first, ties by index
};

// Calls body(i) for every task, each once, in parallel. A task starts only when its bytes fit beside those that run;
// one that exceeds the budget alone runs alone. Throws what a body throws, and Error(interrupted) when
// stop_requested(). What a task computes must not depend on which others run: order and concurrency are free.
void run_pass(std::span<const PassTask> tasks, std::uint64_t budget_bytes,
              const std::function<void(std::size_t)>& body);

// Throws Error(interrupted) when stop_requested().
void stop_if_asked();

}  // namespace ilot
