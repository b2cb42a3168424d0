// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/pass.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

void nap() {
  std::this_thread::sleep_for(std::chrono::microseconds(200));
}

// Bytes and tasks that run at once, and the most there ever were.
struct Watch {
  std::mutex mutex;
  std::uint64_t bytes = 0, most_bytes = 0;
  int running = 0, most_running = 0;
  bool overlapped = false;  // a task above the budget had company

  void enter(std::uint64_t b, std::uint64_t budget) {
    const std::lock_guard lock(mutex);
    bytes += b;
    ++running;
    overlapped = overlapped || (bytes > budget && running > 1);
    most_bytes = std::max(most_bytes, bytes);
    most_running = std::max(most_running, running);
  }
  void leave(std::uint64_t b) {
    const std::lock_guard lock(mutex);
    bytes -= b;
    --running;
  }
};

TEST(Pass, EveryTaskOnceAndTheBudgetIsHonoured) {
  Rng rng(1);
  std::vector<PassTask> tasks(300);
  for (PassTask& t : tasks) t = {rng.below(60), rng.below(10)};
  for (const int threads : {1, 2, 4, 8}) {
    Watch watch;
    std::vector<std::atomic<int>> hits(tasks.size());
    with_threads(threads, [&] {
      run_pass(tasks, 100, [&](std::size_t i) {
        watch.enter(tasks[i].bytes, 100);
        ++hits[i];
        nap();
        watch.leave(tasks[i].bytes);
      });
    });
    for (const auto& h : hits) ASSERT_EQ(h, 1);
    EXPECT_LE(watch.most_bytes, 100u);
    EXPECT_LE(watch.most_running, threads);
    if (threads == 4) {
      EXPECT_GT(watch.most_running, 1);
    }
  }
}

TEST(Pass, ATaskAboveTheBudgetRunsAlone) {
  std::vector<PassTask> tasks(50, PassTask{10, 1});
  tasks[7] = tasks[31] = {1000, 2};
  tasks[40] = {UINT64_MAX, 0};
  for (const std::uint64_t budget : {100u, 1u, 0u}) {
    Watch watch;
    std::atomic<int> done{0};
    with_threads(4, [&] {
      run_pass(tasks, budget, [&](std::size_t i) {
        const std::uint64_t bytes = std::min<std::uint64_t>(tasks[i].bytes, 1000);
        watch.enter(bytes, budget);
        ++done;
        nap();
        watch.leave(bytes);
      });
    });
    EXPECT_EQ(done, 50);
    EXPECT_FALSE(watch.overlapped) << budget;
  }
}

TEST(Pass, WhatIsTooLargeCanBeRefused) {
  std::vector<PassTask> tasks(20, PassTask{10, 1});
  tasks[3].bytes = 101;
  tasks[11].bytes = UINT64_MAX;
  tasks[12].bytes = 100;
  for (const int threads : {1, 4}) {
    std::vector<std::atomic<int>> hits(tasks.size());
    std::vector<std::size_t> refused;
    with_threads(threads, [&] {
      refused = run_pass(
          tasks, 100, [&](std::size_t i) { ++hits[i]; }, TooLarge::refused);
    });
    EXPECT_EQ(refused, (std::vector<std::size_t>{3, 11}));
    for (std::size_t i = 0; i < tasks.size(); ++i) EXPECT_EQ(hits[i], i == 3 || i == 11 ? 0 : 1) << i;
  }
}

// One large task, one that does not fit beside it, and many small ones.
TEST(Pass, SmallTasksPassALargeOneThatWaits) {
  std::vector<PassTask> tasks(500, PassTask{1, 1});
  tasks[0] = {60, 9};
  tasks[1] = {60, 8};
  std::mutex mutex;
  std::vector<std::size_t> started;
  std::atomic<bool> second{false};
  std::atomic<int> before{0};
  with_threads(2, [&] {
    run_pass(tasks, 100, [&](std::size_t i) {
      {
        const std::lock_guard lock(mutex);
        started.push_back(i);
      }
      if (i == 1) second = true;
      if (i > 1 && !second) ++before;
      if (i == 0)
        while (before < 10) std::this_thread::yield();  // as long as small ones do not pass, this does not end
    });
  });
  EXPECT_EQ(started.size(), tasks.size());
  EXPECT_GE(before, 10);
}

// The large task fits only when none of the small ones runs: it must not wait for all of them.
TEST(Pass, OnlySoManyTasksPassOneThatWaits) {
  constexpr std::size_t kSmall = 5000;
  std::vector<PassTask> tasks(kSmall, PassTask{50, 1});
  tasks[0] = {60, 9};
  tasks[1] = {100, 8};
  std::atomic<int> started{0}, place{0};
  with_threads(2, [&] {
    run_pass(tasks, 100, [&](std::size_t i) {
      const int now = started++;
      if (i == 1) place = now;
      if (i == 0) nap();
    });
  });
  EXPECT_EQ(started, static_cast<int>(kSmall));
  EXPECT_LE(place, 200) << "of " << kSmall;
}

// While one task has all the memory, the other threads work in its loops.
TEST(Pass, NoThreadWaitsWhileALoopHasWork) {
  const std::vector<PassTask> tasks(3, PassTask{100, 1});
  with_threads(4, [&] {
    run_pass(tasks, 100, [&](std::size_t) {
      std::mutex mutex;
      std::condition_variable met;
      std::size_t here = 0;
      bool two = false;
      parallel_for(64, [&](std::size_t) {  // each item waits for company, which only another thread can be
        std::unique_lock lock(mutex);
        two = two || ++here > 1;
        met.notify_all();
        EXPECT_TRUE(met.wait_for(lock, std::chrono::seconds(20), [&] { return two; }));
        --here;
      });
    });
  });
}

TEST(Pass, TheLargestStartFirstTiesByIndex) {
  const std::vector<PassTask> tasks{{0, 5}, {0, 9}, {0, 5}, {0, 0}, {0, 9}};
  std::vector<std::size_t> order;
  with_threads(1, [&] { run_pass(tasks, 1, [&](std::size_t i) { order.push_back(i); }); });
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 4, 0, 2, 3}));
  run_pass({}, 1, [](std::size_t) { FAIL(); });
}

TEST(Pass, AnExceptionIsRethrownAndNothingMoreStarts) {
  const std::vector<PassTask> tasks(1000, PassTask{60, 1});  // one at a time: all other threads wait for memory
  for (const int threads : {1, 4}) {
    std::atomic<int> started{0};
    with_threads(threads, [&] {
      EXPECT_THROW(run_pass(tasks, 100,
                            [&](std::size_t) {
                              if (++started == 5) {
                                nap();
                                throw std::runtime_error("disk full");
                              }
                              nap();
                            }),
                   std::runtime_error);
    });
    EXPECT_EQ(started, 5);
  }
}

TEST(Pass, TasksMayUseAllThreadsThemselves) {
  const std::vector<PassTask> tasks(40, PassTask{60, 1});
  std::atomic<int> sum{0};
  with_threads(4, [&] { run_pass(tasks, 100, [&](std::size_t) { parallel_for(100, [&](std::size_t) { ++sum; }); }); });
  EXPECT_EQ(sum, 4000);
}

// The flag cannot be taken back, so it is raised in a process of its own.
[[noreturn]] void stop_in_the_third_task() {
  std::atomic<int> started{0};
  const std::vector<PassTask> tasks(100, PassTask{1, 1});
  try {
    with_threads(1, [&] {
      run_pass(tasks, 1, [&](std::size_t) {
        if (++started == 3) request_stop();
      });
    });
  } catch (const Error& e) {
    std::_Exit(e.code() == ExitCode::interrupted && started == 3 ? 130 : 1);
  }
  std::_Exit(2);
}

[[noreturn]] void stop_in_the_last_task() {
  try {
    run_pass(std::vector<PassTask>(1), 1, [](std::size_t) { request_stop(); });
  } catch (const Error& e) {
    std::_Exit(e.code() == ExitCode::interrupted ? 130 : 1);
  }
  std::_Exit(2);
}

TEST(PassDeathTest, AStopIsAnInterruption) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_NO_THROW(stop_if_asked());
  EXPECT_EXIT(stop_in_the_third_task(), testing::ExitedWithCode(130), "");
  EXPECT_EXIT(stop_in_the_last_task(), testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace ilot
