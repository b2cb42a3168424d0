// SPDX-License-Identifier: Apache-2.0
// One subcommand, one file. Each adds its options to the command line and, when it is the one that was called, leaves
// in `action` what is to be done; main runs it and turns its answer into the exit code.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace ilot {

using Action = std::function<int()>;

void add_run_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_convert_command(CLI::App& app, Action& action);
void add_replay_command(CLI::App& app, Action& action);
void add_scan_command(CLI::App& app, Action& action);
void add_draw_command(CLI::App& app, Action& action);
void add_evaluate_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_validate_command(CLI::App& app, Action& action);

}  // namespace ilot
