// SPDX-License-Identifier: Apache-2.0
// Ctrl-C while the library works: the run stops soon and can be resumed, as that of the program.
#pragma once
#include <atomic>

namespace ilot {

// From construction to destruction SIGINT sets `stop`, if this is the main thread: Python gives Ctrl-C to that thread
// alone, so that runs of other threads go on.
class InterruptGuard {
 public:
  InterruptGuard(bool main_thread, std::atomic<bool>& stop);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  // Whether SIGINT came since construction.
  bool came() const;

 private:
  bool active_;
  void (*before_)(int) = nullptr;
};

}  // namespace ilot
