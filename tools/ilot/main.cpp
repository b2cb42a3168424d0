// SPDX-License-Identifier: Apache-2.0
// The command line of ilot. Only this file catches exceptions and determines the exit code.
#include <malloc.h>

#include <csignal>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "engine/run/forced_isa.h"
#include "engine/system_reason.h"
#include "engine/version.h"
#include "kernels/simd/forced_isa.h"
#include "kernels/simd/variants.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/usage_fault.h"

namespace {

using namespace ilot;

// The first signal requests an orderly stop. The handler is removed then, so the second signal ends the process. SIGHUP
// stays ignored where the parent ignores it (nohup).
void install_signal_handlers() {
  struct sigaction stop {};
  stop.sa_handler = [](int) { request_stop(); };
  stop.sa_flags = SA_RESETHAND | SA_RESTART;
  sigset_t asked;  // a parent may have blocked these signals
  sigemptyset(&asked);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (number == SIGHUP && before.sa_handler == SIG_IGN) continue;
    sigaction(number, &stop, nullptr);
    sigaddset(&asked, number);
  }
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);  // writing beyond ulimit -f becomes an error like a full disk
  sigprocmask(SIG_UNBLOCK, &asked, nullptr);
}

std::string version_text(bool json) {
  if (!json) return "ilot " + version() + " (" + git_hash() + ")\n";
  nlohmann::ordered_json all{{"version", version()},
                             {"git_hash", git_hash()},
                             {"compiler", compiler()},
                             {"build_type", build_type()},
                             {"isa", simd::name_of(simd::chosen_isa())},
                             {"isas", simd::available_isas()}};
  for (const auto& [name, number] : library_versions()) all["libraries"][name] = number;
  return all.dump(2) + "\n";
}

std::string fault_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return "ilot: " + text + "\n";
}

int run_command_line(int argc, char** argv) {
  check_forced_isa();
  CLI::App app("Turns point clouds of cities into drawings and models.", "ilot");
  bool show_version = false, json = false;
  auto* version_flag = app.add_flag("--version", show_version, "show version and git hash");
  app.add_flag("--json", json, "with --version: all of the build as JSON")->needs(version_flag);
  app.require_subcommand(0, 1);
  app.footer(
      "Exit codes: 0 done, 1 failed, 2 usage, 3 done but something was skipped, 130 interrupted.\n"
      "Example: ilot run city.las -o out\n");
  Action action;
  add_run_command(app, action);
  add_info_command(app, action);
  add_convert_command(app, action);
  add_scan_command(app, action);
  add_draw_command(app, action);
  add_export_command(app, action);
  add_edits_command(app, action);
  add_evaluate_command(app, action);
  add_render_command(app, action);
  add_replay_command(app, action);
  add_plan_command(app, action);
  add_task_command(app, action);
  add_merge_command(app, action);
  add_report_command(app, action);
  add_validate_command(app, action);
  add_view_command(app, action);
  add_doctor_command(app, action);
  add_manual_commands(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto called = app.get_subcommands();
    print(called.empty() ? app.help() : called.front()->help("ilot"));
    return 0;
  } catch (const CLI::ParseError& fault) {
    throw Error(usage_fault(app, fault), ExitCode::usage);
  }
  if (show_version) {
    print(version_text(json));
    return 0;
  }
  if (app.get_subcommands().empty())
    throw Error("no command given; the first is ilot info CLOUD or ilot run CLOUD -o OUT (ilot --help)",
                ExitCode::usage);
  return action ? action() : 0;
}

// The message of the library begins with the name of a C++ function, which is removed.
std::string fault_of_path(const std::filesystem::filesystem_error& fault) {
  const std::string path = fault.path1().empty() ? std::string("a file") : fault.path1().string();
  const std::string other = fault.path2().empty() ? "" : " (to " + fault.path2().string() + ")";
  return path + other + ": cannot be worked on: " + system_reason(fault.code().value()) +
         "; mend this, then start again or --resume";
}

}  // namespace

int main(int argc, char** argv) {
  install_signal_handlers();
  if (stop_requested()) {  // the signal came while the program was loading, and the parent had blocked it
    say(fault_line("interrupted before anything was begun"));
    return static_cast<int>(ExitCode::interrupted);
  }
  // Freed blocks return to the system and not to a pool that --memory does not count.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  try {
    return run_command_line(argc, argv);
  } catch (const Error& fault) {
    say(fault_line(fault.what()));
    return static_cast<int>(fault.code());
  } catch (const std::bad_alloc&) {
    say(fault_line("out of memory: give a smaller --memory or free some"));
  } catch (const std::filesystem::filesystem_error& fault) {
    say(fault_line(fault_of_path(fault)));
  } catch (const std::exception& fault) {
    say(fault_line(std::string("internal error: ") + fault.what() + "; please report it with the command"));
  }
  return static_cast<int>(ExitCode::failed);
}
