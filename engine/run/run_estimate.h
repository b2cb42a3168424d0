// SPDX-License-Identifier: Apache-2.0
// An estimate, before a run begins, of what it will need.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/report/progress.h"
#include "engine/run/inputs/open_inputs.h"

namespace ilot {

struct RunEstimate {
  std::uint64_t store_bytes = 0;   // greatest size of the store at any time
  std::uint64_t result_bytes = 0;  // an upper bound: clouds are written compressed
  double processor_seconds = 0;    // approximate: the time of classifiers differs by a factor of two, and so do clouds
};

RunEstimate estimate_run(const RunOptions& options, const RunInputs& inputs);

// Returns the stages that a run with these options will have, in their order and with their relative times, for the
// display of its progress.
std::vector<PlannedStage> planned_stages(const RunOptions& options);

}  // namespace ilot
