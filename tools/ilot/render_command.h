// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>

namespace ilot {

// `ilot render FILE -o out.png`: a picture of a cloud. Runs when its arguments are parsed; throws Error.
void add_render_command(CLI::App& app);

}  // namespace ilot
