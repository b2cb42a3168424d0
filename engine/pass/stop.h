// SPDX-License-Identifier: Apache-2.0
// The one flag of the process that records a request to stop the run. The signal handlers of the command line set it;
// code that distributes work reads it. Both functions are safe in a signal handler and from any thread.
#pragma once

namespace ilot {

// True after request_stop() was called. Then start nothing new, flush what makes the run resumable, and throw
// Error(..., ExitCode::interrupted).
bool stop_requested();

// Ends the current run; declared here and in ilot/run.h.
void request_stop();

// Clears the request so that the next run can start. Must not be called while a run works.
void accept_runs();

}  // namespace ilot
