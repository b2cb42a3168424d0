// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
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

// A thread that waits for an inner loop must not start an item of the outer one: its memory would be held twice.
TEST(Parallel, AWaitingThreadTakesNoOuterItem) {
  with_threads(4, [] {
    std::atomic<bool> doubled{false};
    parallel_for(64, [&](std::size_t) {
      thread_local int depth = 0;
      if (++depth > 1) doubled = true;
      std::atomic<int> sum{0};
      parallel_for(64, [&](std::size_t) { ++sum; });
      EXPECT_EQ(sum, 64);
      --depth;
    });
    EXPECT_FALSE(doubled);
  });
}

}  // namespace
}  // namespace ilot
