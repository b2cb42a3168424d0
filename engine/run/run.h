// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/classes/training_sample.h"
#include "engine/report/progress.h"
#include "engine/run/options.h"

namespace ilot {

// Runs the given options and writes OUT with run.json. Returns the exit code: 0 done, 3 done but something was skipped
// or a product is empty. Throws Error for 1 failed, 2 usage and 130 interrupted (resumable). `learn` is the method that
// makes a model from the places that options.train names; empty: models are only read.
int run(const RunOptions& options, Progress& progress, const TrainObjectModel& learn = {});

}  // namespace ilot
