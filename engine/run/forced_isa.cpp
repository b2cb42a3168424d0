// SPDX-License-Identifier: Apache-2.0
#include "engine/run/forced_isa.h"

#include "engine/error.h"
#include "kernels/simd/forced_isa.h"

namespace ilot {

void check_forced_isa() {
  const std::string forced = simd::unavailable_forced_isa();
  if (forced.empty()) return;
  std::string names;
  for (const std::string& name : simd::available_isas()) names += (names.empty() ? "" : ", ") + name;
  throw Error("ILOT_FORCE_ISA=" + forced + ": this machine has " + names + "; name one of these or unset the variable",
              ExitCode::usage);
}

}  // namespace ilot
