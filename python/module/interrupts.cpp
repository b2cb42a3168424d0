// SPDX-License-Identifier: Apache-2.0
#include "python/module/interrupts.h"

#include <csignal>

namespace ilot {

namespace {

// What the signal handler sets: of the call of the main thread, of which there is one at a time.
std::atomic<std::atomic<bool>*> g_stop{nullptr};
std::atomic<bool> g_came{false};

void stop_on_signal(int) {
  g_came = true;
  if (std::atomic<bool>* stop = g_stop.load()) stop->store(true);
}

}  // namespace

InterruptGuard::InterruptGuard(bool main_thread, std::atomic<bool>& stop) : active_(main_thread) {
  if (!active_) return;
  g_came = false;
  g_stop = &stop;
  before_ = std::signal(SIGINT, stop_on_signal);
}

InterruptGuard::~InterruptGuard() {
  if (!active_) return;
  std::signal(SIGINT, before_);
  g_stop = nullptr;
}

bool InterruptGuard::came() const {
  return active_ && g_came;
}

}  // namespace ilot
