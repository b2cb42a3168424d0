// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

namespace ilot {

// Takes further work while other work runs.
class TaskGroup {
 public:
  virtual void run(std::function<void()> work) = 0;

 protected:
  ~TaskGroup() = default;
};

// Calls start(group), then returns when all work that was given to the group is done, by start or by other work of the
// group. Work runs on the threads of the calling arena, in any order, and must not throw. A thread that has no work of
// the group helps the parallel loops of those that have. Not to be called from within a parallel loop: the thread that
// waits here would start other items of that loop.
void run_tasks(const std::function<void(TaskGroup&)>& start);

}  // namespace ilot
