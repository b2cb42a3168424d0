// SPDX-License-Identifier: Apache-2.0
// The flags that record a request to stop. The signal handlers of the command line set that of the process; code that
// distributes work reads them. The functions are safe in a signal handler and from any thread.
#pragma once

namespace ilot {

// True after request_stop() was called. Then start nothing new, flush what makes the run resumable, and throw
// Error(..., ExitCode::interrupted).
bool stop_requested();

// Ends the current run; declared here and in ilot/run.h.
void request_stop();

// Clears the request so that the next run can start. Must not be called while a run works.
void accept_runs();

// Ends the run that is at work, and no other: neither one that waits for it nor other work in this process.
void stop_this_run();

// True after stop_this_run() or request_stop(): for the passes of runs.
bool run_stop_requested();

// One run at work; there is one at a time in a process. A request to stop it is forgotten with it.
class RunAtWork {
 public:
  RunAtWork();
  ~RunAtWork();
  RunAtWork(const RunAtWork&) = delete;
  RunAtWork& operator=(const RunAtWork&) = delete;
};

}  // namespace ilot
