// SPDX-License-Identifier: Apache-2.0
// Runs the independent tasks of one stage on all threads, within a budget of memory.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ilot {

struct PassTask {
  std::uint64_t bytes = 0;   // estimate of the memory that it holds while it runs
  std::uint64_t points = 0;  // for ordering: the largest start first, ties by index
};

// What becomes of a task whose bytes alone exceed the budget.
enum class TooLarge : std::uint8_t {
  alone,    // it runs while no other does, and exceeds the budget
  refused,  // it does not run, and the caller says so or works in pieces
};

// Calls body(i) for every task, each once, in parallel, and returns the tasks that were refused, ascending. A task
// starts only when its bytes fit beside those that run; no thread waits for that, it helps the parallel loops of the
// tasks that run. While a task waits for memory, smaller ones start before it, but only a bounded number of them.
// Throws what a body throws, and Error(interrupted) when stop_requested(). What a task computes must not depend on
// which others run: order and concurrency are free. Which tasks are refused depends on their bytes and the budget
// alone. Not to be called from within a task or a parallel loop.
std::vector<std::size_t> run_pass(std::span<const PassTask> tasks, std::uint64_t budget_bytes,
                                  const std::function<void(std::size_t)>& body, TooLarge too_large = TooLarge::alone);

// Throws Error(interrupted) when stop_requested().
void stop_if_asked();

}  // namespace ilot
