// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>

namespace ilot {

// `ilot scan SCENE -o FILE`: the virtual scanner. Runs when its arguments are parsed; throws Error.
void add_scan_command(CLI::App& app);

}  // namespace ilot
