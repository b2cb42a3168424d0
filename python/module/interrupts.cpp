// SPDX-License-Identifier: Apache-2.0
#include "python/module/interrupts.h"

#include <csignal>

#include "ilot/run.h"

namespace ilot {

namespace {

volatile std::sig_atomic_t g_came = 0;

void stop_on_signal(int) {
  g_came = 1;
  request_stop();
}

}  // namespace

InterruptGuard::InterruptGuard(bool main_thread) : active_(main_thread) {
  g_came = 0;
  if (active_) before_ = std::signal(SIGINT, stop_on_signal);
}

InterruptGuard::~InterruptGuard() {
  if (active_) std::signal(SIGINT, before_);
  if (came()) accept_runs();
}

bool InterruptGuard::came() {
  return g_came != 0;
}

}  // namespace ilot
