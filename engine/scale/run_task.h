// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

#include "engine/report/progress.h"

namespace ilot {

struct TaskOptions {
  std::filesystem::path plan;
  std::uint64_t number = 0;  // of an area, or with `label` of an input; from 1
  std::uint64_t memory_bytes = std::uint64_t{2} << 30;
  int threads = 0;
  std::filesystem::path work;    // for the store while the task works; empty: beside the parts
  bool label = false;            // writes the labelled cloud of an input; see label_task.h
  std::filesystem::path output;  // with `label`: the folder of the merged result
};

// Works on one area of a plan and writes PLAN/parts/N, or labels one input; both appear whole or not at all. Returns
// ok, also where the part is there already, or incomplete where a building has no model. Throws Error: usage and failed
// for what the next try cannot mend, try_again for the rest (a full disk, too little memory of the machine, a signal).
int run_task(const TaskOptions& options, Progress& progress);

}  // namespace ilot
