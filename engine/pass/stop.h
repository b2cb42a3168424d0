// SPDX-License-Identifier: Apache-2.0
// The one process-wide flag: has somebody asked the run to stop? Set by the signal handlers of the command
// line, read by whoever hands out work. Both functions are safe in a signal handler and from any thread.
#pragma once

namespace ilot {

// True once request_stop() was called: start nothing new, flush what makes the run resumable, then throw
// Error(..., ExitCode::interrupted).
bool stop_requested();

// Ends what runs: declared here and in ilot/run.h.
void request_stop();

// Takes the request back: the next run starts. Not while one runs.
void accept_runs();

}  // namespace ilot
