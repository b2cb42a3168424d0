// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <utility>

#include "kernels/core/task_group.h"

namespace ilot {
namespace {

class Group final : public TaskGroup {
 public:
  // A task is enqueued, because a task that is spawned may wake no thread: a thread that went to sleep stayed asleep
  // for the rest of a run. The only thread of an arena takes its tasks itself; enqueuing would start a second thread.
  void run(std::function<void()> work) override {
    if (tbb::this_task_arena::max_concurrency() == 1) return group_.run(std::move(work));
    tbb::this_task_arena::enqueue(group_.defer(std::move(work)));
  }
  void wait() { group_.wait(); }

 private:
  tbb::task_group group_;
};

}  // namespace

void run_tasks(const std::function<void(TaskGroup&)>& start) {
  Group group;
  start(group);
  group.wait();
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  if (count == 0) return;
  tbb::this_task_arena::isolate([&] {
    if (count == 1) return body(0);
    tbb::parallel_for(
        std::size_t{0}, count, [&](std::size_t i) { body(i); }, tbb::simple_partitioner());
  });
}

void with_threads(int threads, const std::function<void()>& body) {
  const int n = std::max(1, threads);
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n));
  tbb::task_arena arena(n);
  arena.execute(body);
}

int thread_count() {
  return tbb::this_task_arena::max_concurrency();
}

int hardware_threads() {
  return tbb::info::default_concurrency();
}

}  // namespace ilot
