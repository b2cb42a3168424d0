// SPDX-License-Identifier: Apache-2.0
#include "engine/run/stray_warning.h"

namespace ilot {

void warn_of_strays(std::uint64_t strays, Progress& progress, RunRecord& record) {
  if (strays == 0) return;
  const std::string text = grouped(strays) + (strays == 1 ? " point stands" : " points stand") +
                           " alone, far from all others, and " + (strays == 1 ? "is" : "are") +
                           " left out; index.keep_strays = true keeps such points";
  progress.warn(text);
  record.warnings.push_back(text);
}

}  // namespace ilot
