// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/pass/index.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"

namespace ilot {

// Says and records how many points an index left out because they stand alone. Says nothing where there are none.
void warn_of_strays(const IndexResult& index, Progress& progress, RunRecord& record);

}  // namespace ilot
