// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/pass.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "engine/error.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/resident.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "kernels/core/task_group.h"

namespace ilot {
namespace {

constexpr int kMostPassed = 64;  // smaller tasks that start while one waits; enough to fill the remaining memory

// Decides which task starts next. Only one thread at a time executes this code.
class Queue {
 public:
  Queue(std::span<const PassTask> tasks, std::uint64_t budget, TooLarge too_large)
      : tasks_(tasks),
        total_(std::max<std::uint64_t>(std::min(budget, free_memory()), 1)),
        free_(total_),
        taken_(tasks.size()) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (tasks[i].bytes > budget && too_large == TooLarge::refused) {
        refused_.push_back(i);
        taken_[i] = true;
      } else {
        order_.push_back(i);
        by_bytes_.insert({bytes(i), i});
      }
    }
    std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return tasks[a].points > tasks[b].points; });
  }

  std::optional<std::size_t> take() {
    while (next_ < order_.size() && taken_[order_[next_]]) ++next_, passed_ = 0;
    if (next_ == order_.size()) return std::nullopt;
    const std::uint64_t room = running_ == 0 ? free_ : std::min(free_, free_memory());
    if (bytes(order_[next_]) <= room) return start(order_[next_]);
    if (passed_ == kMostPassed) return std::nullopt;
    auto fitting = by_bytes_.upper_bound({room, SIZE_MAX});
    if (fitting == by_bytes_.begin()) return std::nullopt;
    ++passed_;
    return start((--fitting)->second);
  }

  void finish(std::size_t task) {
    free_ += bytes(task);
    --running_;
  }

  void drop() { next_ = order_.size(); }
  int running() const { return running_; }
  std::vector<std::size_t> refused() { return std::move(refused_); }

 private:
  std::uint64_t bytes(std::size_t task) const { return std::min(tasks_[task].bytes, total_); }

  std::size_t start(std::size_t task) {
    taken_[task] = true;
    by_bytes_.erase({bytes(task), task});
    free_ -= bytes(task);
    ++running_;
    return task;
  }

  std::span<const PassTask> tasks_;
  std::uint64_t total_, free_;  // of the budget; what the process does not use already
  std::vector<bool> taken_;
  std::vector<std::size_t> order_, refused_;
  std::set<std::pair<std::uint64_t, std::size_t>> by_bytes_;  // waiting tasks
  std::size_t next_ = 0;
  int running_ = 0, passed_ = 0;
};

// The thread that has finished a task looks for further tasks, as many as threads and memory allow, and gives them to
// the group. No thread waits for memory.
class Runner {
 public:
  Runner(Queue& queue, const std::function<void(std::size_t)>& body)
      : queue_(queue), body_(body), threads_(thread_count()) {}

  void run() {
    run_tasks([&](TaskGroup& group) { start_more(group); });
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  void start_more(TaskGroup& group) {
    const std::lock_guard lock(mutex_);
    while (queue_.running() < threads_) {
      const std::optional<std::size_t> task = queue_.take();
      if (!task) return;
      group.run([this, &group, i = *task] { work(group, i); });
    }
  }

  void work(TaskGroup& group, std::size_t task) {
    try {
      if (!failed()) {
        stop_if_asked();
        body_(task);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!fault_) fault_ = std::current_exception();
      queue_.drop();
    }
    close_gaps();
    {
      const std::lock_guard lock(mutex_);
      queue_.finish(task);
    }
    start_more(group);
  }

  bool failed() {
    const std::lock_guard lock(mutex_);
    return fault_ != nullptr;
  }

  Queue& queue_;
  const std::function<void(std::size_t)>& body_;
  int threads_;
  std::mutex mutex_;
  std::exception_ptr fault_;
};

}  // namespace

void stop_if_asked() {
  if (run_stop_requested()) throw Error("interrupted; the same command with --resume goes on", ExitCode::interrupted);
}

std::vector<std::size_t> run_pass(std::span<const PassTask> tasks, std::uint64_t budget_bytes,
                                  const std::function<void(std::size_t)>& body, TooLarge too_large) {
  trim_memory();
  std::uint64_t largest = 0;
  for (const PassTask& task : tasks) largest = std::max(largest, task.bytes);
  const auto together = std::min<std::uint64_t>(tasks.size(), static_cast<std::uint64_t>(thread_count()));
  const ColumnRoom room(std::max(largest, std::min(budget_bytes, largest * together)));
  Queue queue(tasks, budget_bytes, too_large);
  Runner(queue, body).run();
  stop_if_asked();
  return queue.refused();
}

}  // namespace ilot
