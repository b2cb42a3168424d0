// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

#include "engine/report/progress.h"

namespace ilot {

// Warns where the process took more than `memory_bytes` (--memory), which was too small for one of the steps that
// docs/limits.md lists, and returns the warning: it says what is enough. Empty where the memory was kept.
std::string warn_of_peak(std::uint64_t memory_bytes, Progress& progress);

}  // namespace ilot
