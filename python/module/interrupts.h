// SPDX-License-Identifier: Apache-2.0
// Ctrl-C while the library works: the run stops soon and can be resumed, as that of the program.
#pragma once

namespace ilot {

// From construction to destruction SIGINT asks the library to stop, if this is the main thread. There is at most one at
// a time, since runs of one process follow one another.
class InterruptGuard {
 public:
  explicit InterruptGuard(bool main_thread);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  // Whether SIGINT came since construction.
  static bool came();

 private:
  bool active_;
  void (*before_)(int) = nullptr;
};

}  // namespace ilot
