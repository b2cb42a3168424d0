// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/report/progress.h"
#include "engine/run/options.h"

namespace ilot {

// What `ilot plan` is asked for. `run` has the inputs, products, settings, footprints, CRS, memory and threads of one
// run; its output is the folder of the plan.
struct PlanOptions {
  RunOptions run;
  double area_size = 0;              // metres; 0: chosen from the points
  std::filesystem::path statistics;  // a plan whose values of `auto` are kept; none
  std::filesystem::path update;      // a plan whose values and valid parts are kept, and that says all else; none
  std::string parts;                 // URL of an object store for the parts; empty: the folder of the plan
  bool labels = false;               // parts of roofs alone are to have what labelled clouds need; others have it
};

// The options of a plan that is to replace another: all that is not given is as in the other plan.
PlanOptions options_of_update(PlanOptions given);

// Reads all inputs once, measures what depends on all points, and writes the folder of a plan: plan.json, last, and
// sites/. Throws Error, with ExitCode::usage for a product whose areas would not give the bytes of one run. Returns the
// exit code: ok, or incomplete where an input was skipped.
int make_plan(const PlanOptions& options, Progress& progress);

// What the tasks of a plan need in all, and the largest of them: lines for people.
std::string plan_estimate(const std::filesystem::path& folder);

}  // namespace ilot
