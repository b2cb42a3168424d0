// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>

namespace ilot {

// `ilot evaluate FILE --truth-fields`: judges labelled points against the truth they carry. Runs when its
// arguments are parsed; throws Error.
void add_evaluate_command(CLI::App& app);

}  // namespace ilot
