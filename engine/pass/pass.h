// SPDX-License-Identifier: Apache-2.0
// Runs the independent tasks of one stage on all threads, within a memory budget.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ilot {

struct PassTask {
  std::uint64_t bytes = 0;   // estimated memory of the task while it runs
  std::uint64_t points = 0;  // for the order: the largest task starts first, ties by index
};

// What happens to a task whose bytes alone exceed the budget.
enum class TooLarge : std::uint8_t {
  alone,    // it runs while no other task runs, and exceeds the budget
  refused,  // it does not run; the caller reports this or divides the work
};

// Calls body(i) once for every task, in parallel, and returns the refused tasks, ascending. A task starts only when its
// bytes fit beside those of the running tasks. No thread waits for that: it helps with the parallel loops of the
// running tasks. While a task waits for memory, smaller ones start before it, but only a bounded number of them. Throws
// what a body throws, and Error(interrupted) when run_stop_requested(). The result of a task must not depend on which
// others run: order and concurrency are free. Which tasks are refused depends only on their bytes and the budget. Must
// not be called from within a task or a parallel loop.
std::vector<std::size_t> run_pass(std::span<const PassTask> tasks, std::uint64_t budget_bytes,
                                  const std::function<void(std::size_t)>& body, TooLarge too_large = TooLarge::alone);

// Throws Error(interrupted) when run_stop_requested().
void stop_if_asked();

}  // namespace ilot
