// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/report/progress.h"
#include "engine/run/options.h"

namespace ilot {

// Does what the options say and writes OUT with run.json. Returns the exit code: 0 done, 3 done but something
// was skipped or a product is empty. Throws Error for 1 failed, 2 usage and 130 interrupted (resumable).
int run(const RunOptions& options, Progress& progress);

}  // namespace ilot
