// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

#include "engine/report/progress.h"

namespace ilot {

struct MergeOptions {
  std::filesystem::path plan, output;
  bool allow_missing = false;                             // areas without a part are holes, which run.json lists
  bool report = true;                                     // write report.html
  bool labels = false;                                    // leave labels in the plan, for tasks that write clouds
  std::uint64_t memory_bytes = std::uint64_t{512} << 20;  // models of roofs alone need little
  int threads = 0;                                        // 0: all; models of roofs alone take one
};

// Makes one result of the parts of a plan: the files that one run would have written, with ids in its order. Throws
// Error, with ExitCode::usage where parts are missing, of another plan, or damaged. Returns ok or incomplete.
int merge_parts(const MergeOptions& options, Progress& progress);

}  // namespace ilot
