// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/report/progress.h"
#include "engine/scale/plan.h"
#include "engine/scale/run_task.h"

namespace ilot {

// Writes the labelled cloud of input task.number to OUT/points, from the labels that a merge has left in the plan. The
// cloud appears whole or not at all, with the bytes of one run. The task after which all clouds are there adds them to
// OUT/run.json.
void label_input(const TaskOptions& task, const Plan& plan, Progress& progress);

}  // namespace ilot
