// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace ilot {
namespace {

TEST(Parallel, EveryItemOnceForAnyCountAndThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    with_threads(threads, [&] {
      for (const std::size_t count : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> hits(count);
        parallel_for(count, [&](std::size_t i) { ++hits[i]; });
        for (const auto& h : hits) ASSERT_EQ(h, 1) << threads << " threads, " << count << " items";
      }
    });
  }
}

TEST(Parallel, TheArenaHasTheThreadsAskedForAndNoMoreRunAtOnce) {
  EXPECT_GE(hardware_threads(), 1);
  for (const int threads : {1, 2, 5}) {
    with_threads(threads, [&] {
      EXPECT_EQ(thread_count(), threads);
      std::atomic<int> running{0}, most{0};
      parallel_for(500, [&](std::size_t) {
        const int now = ++running;
        for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
        }
        --running;
      });
      EXPECT_LE(most, threads);
    });
  }
  with_threads(-3, [] { EXPECT_EQ(thread_count(), 1); });
}

TEST(Parallel, AnExceptionIsRethrownAndStopsTheHandingOut) {
  std::atomic<int> done{0};
  try {
    with_threads(2, [&] {
      parallel_for(1000000, [&](std::size_t i) {
        if (i == 10) throw std::runtime_error("item 10");
        ++done;
      });
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "item 10");
  }
  EXPECT_LT(done, 999999);
  std::atomic<int> after{0};
  parallel_for(100, [&](std::size_t) { ++after; });
  EXPECT_EQ(after, 100);
}

TEST(Parallel, NestedLoopsDoEverythingAndThrowThroughBothLevels) {
  std::vector<std::atomic<int>> hits(20 * 30);
  parallel_for(20, [&](std::size_t i) { parallel_for(30, [&](std::size_t j) { ++hits[i * 30 + j]; }); });
  for (const auto& h : hits) ASSERT_EQ(h, 1);
  EXPECT_THROW(parallel_for(20,
                            [](std::size_t i) {
                              parallel_for(30, [&](std::size_t j) {
                                if (i == 7 && j == 3) throw std::runtime_error("deep");
                              });
                            }),
               std::runtime_error);
}

// A thread that waits for an inner loop must not start an item of the outer one: its memory would be held twice. An
// inner item that another thread took holds its owner up until one more outer item has begun: where waiting threads
// take what they find, the owner does so in many of the rounds. Held is one at a time and for so many turns at most, so
// that there is no need of a third thread.
TEST(Parallel, AWaitingThreadTakesNoOuterItem) {
  constexpr std::size_t kOuter = 8, kInner = 4;
  constexpr int kRounds = 200, kOwnTurns = 20, kMostTurns = 2000;
  std::atomic<int> doubled{0}, done{0};
  with_threads(4, [&] {
    for (int round = 0; round < kRounds; ++round) {
      std::atomic<std::size_t> begun{0};
      std::atomic<bool> held{false};
      parallel_for(kOuter, [&](std::size_t) {
        thread_local int depth = 0;
        doubled += ++depth > 1;
        ++begun;
        const std::thread::id owner = std::this_thread::get_id();
        parallel_for(kInner, [&](std::size_t) {
          ++done;
          if (std::this_thread::get_id() == owner) {
            for (int turn = 0; turn < kOwnTurns; ++turn) std::this_thread::yield();
          } else if (!held.exchange(true)) {
            const std::size_t before = begun;
            for (int turn = 0; turn < kMostTurns && begun == before; ++turn) std::this_thread::yield();
            held = false;
          }
        });
        --depth;
      });
    }
  });
  EXPECT_EQ(doubled, 0);
  EXPECT_EQ(done, kRounds * static_cast<int>(kOuter * kInner));
}

}  // namespace
}  // namespace ilot
