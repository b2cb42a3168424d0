// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "engine/report/progress.h"
#include "engine/report/run_record.h"

namespace ilot {

// Says and records how many points were left out because they stand alone. Says nothing where there are none.
void warn_of_strays(std::uint64_t strays, Progress& progress, RunRecord& record);

}  // namespace ilot
