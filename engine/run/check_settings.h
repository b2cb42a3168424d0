// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/columns/run_inputs.h"
#include "engine/settings/settings.h"

namespace ilot {

// Checks what only the inputs show about the settings, and lists whose numbers belong together. Throws Error with
// ExitCode::usage.
void check_settings(const Settings& settings, const RunInputs& inputs);

}  // namespace ilot
