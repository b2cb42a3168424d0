// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/report/progress.h"
#include "engine/report/run_record.h"

namespace ilot {

// Where a product writes its files, reports its progress, and leaves its counts.
struct ProductOutput {
  std::filesystem::path folder;
  Progress& progress;
  RunRecord& record;
};

}  // namespace ilot
