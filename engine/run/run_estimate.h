// SPDX-License-Identifier: Apache-2.0
// What a run will need, told before it begins.
#pragma once
#include <cstdint>

#include "engine/run/open_inputs.h"

namespace ilot {

struct RunEstimate {
  std::uint64_t store_bytes = 0;   // the most that the store takes at any time
  std::uint64_t result_bytes = 0;  // an upper bound: clouds are written compressed
  double processor_seconds = 0;    // roughly: classifiers differ by a factor of two, and so do clouds
};

RunEstimate estimate_run(const RunOptions& options, const RunInputs& inputs);

}  // namespace ilot
