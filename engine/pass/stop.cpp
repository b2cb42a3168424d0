// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/stop.h"

#include <atomic>

namespace ilot {
namespace {

std::atomic<bool> stop_flag{false};      // of the process
std::atomic<bool> run_stop_flag{false};  // of the run at work
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

}  // namespace

bool stop_requested() {
  return stop_flag.load(std::memory_order_relaxed);
}

void accept_runs() {
  stop_flag.store(false, std::memory_order_relaxed);
}

void request_stop() {
  stop_flag.store(true, std::memory_order_relaxed);
}

void stop_this_run() {
  run_stop_flag.store(true, std::memory_order_relaxed);
}

bool run_stop_requested() {
  return run_stop_flag.load(std::memory_order_relaxed) || stop_requested();
}

RunAtWork::RunAtWork() {
  run_stop_flag.store(false, std::memory_order_relaxed);
}

RunAtWork::~RunAtWork() {
  run_stop_flag.store(false, std::memory_order_relaxed);
}

}  // namespace ilot
