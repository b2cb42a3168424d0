// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/pass.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <vector>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

// Bytes that running tasks may hold together. Whoever waits holds nothing, so there is always progress.
class Budget {
 public:
  explicit Budget(std::uint64_t bytes) : free_(bytes), total_(bytes) {}

  std::uint64_t acquire(std::uint64_t bytes) {
    bytes = std::min(bytes, total_);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return bytes <= free_; });
    free_ -= bytes;
    return bytes;
  }
  void release(std::uint64_t bytes) {
    {
      const std::lock_guard lock(mutex_);
      free_ += bytes;
    }
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t free_, total_;
};

class Admission {
 public:
  Admission(Budget& budget, std::uint64_t bytes) : budget_(budget), bytes_(budget.acquire(bytes)) {}
  ~Admission() { budget_.release(bytes_); }
  Admission(const Admission&) = delete;
  Admission& operator=(const Admission&) = delete;

 private:
  Budget& budget_;
  std::uint64_t bytes_;
};

}  // namespace

void stop_if_asked() {
  if (stop_requested()) throw Error("interrupted; the same command with --resume goes on", ExitCode::interrupted);
}

void run_pass(std::span<const PassTask> tasks, std::uint64_t budget_bytes,
              const std::function<void(std::size_t)>& body) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return tasks[a].points > tasks[b].points; });
  Budget budget(std::max<std::uint64_t>(budget_bytes, 1));
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  // One worker per thread takes tasks in order: the scheduler's own order of a parallel loop is not largest first.
  parallel_for(static_cast<std::size_t>(thread_count()), [&](std::size_t) {
    for (std::size_t i = next++; i < order.size(); i = next++) {
      stop_if_asked();
      const Admission admission(budget, tasks[order[i]].bytes);
      if (failed) return;  // while it waited
      try {
        body(order[i]);
      } catch (...) {
        failed = true;
        next = order.size();
        throw;
      }
    }
  });
  stop_if_asked();
}

}  // namespace ilot
