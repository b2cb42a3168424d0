// SPDX-License-Identifier: Apache-2.0
// There is one subcommand per file. Each function adds the options of its subcommand to the command line. If this
// subcommand is called, the function stores the work to be done in `action`. main() runs it and converts its result
// into the exit code.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace ilot {

using Action = std::function<int()>;

void add_run_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_convert_command(CLI::App& app, Action& action);
void add_replay_command(CLI::App& app, Action& action);
void add_plan_command(CLI::App& app, Action& action);
void add_task_command(CLI::App& app, Action& action);
void add_merge_command(CLI::App& app, Action& action);
void add_scan_command(CLI::App& app, Action& action);
void add_draw_command(CLI::App& app, Action& action);
void add_export_command(CLI::App& app, Action& action);
void add_edits_command(CLI::App& app, Action& action);
void add_evaluate_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_validate_command(CLI::App& app, Action& action);
void add_view_command(CLI::App& app, Action& action);
void add_doctor_command(CLI::App& app, Action& action);
void add_manual_commands(CLI::App& app, Action& action);  // `manual` and `completion`

}  // namespace ilot
