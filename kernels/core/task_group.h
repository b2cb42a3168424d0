// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

namespace ilot {

// A group of tasks. It accepts further tasks while others run.
class TaskGroup {
 public:
  virtual void run(std::function<void()> work) = 0;

 protected:
  ~TaskGroup() = default;
};

// Calls start(group) and returns when all tasks of the group are done. Tasks are given to the group by start or by
// other tasks of the group. They run on the threads of the calling arena, in any order, and must not throw. A thread
// that has no task of the group helps the parallel loops of the tasks that run. Do not call this function from within a
// parallel loop, because the waiting thread would start other items of that loop.
void run_tasks(const std::function<void(TaskGroup&)>& start);

}  // namespace ilot
