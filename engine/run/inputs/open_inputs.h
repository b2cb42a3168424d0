// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/columns/run_inputs.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/run/options.h"

namespace ilot {

// Opens every input and chooses one CRS (input_crs.h). Files that cannot be read are skipped and recorded (Error with
// --strict or when none is left). Mixed CRS and degrees are Errors with ExitCode::usage.
RunInputs open_inputs(const RunOptions& options, Progress& progress, RunRecord& record);

}  // namespace ilot
