// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <string>

#include "engine/deliverables/report/report.h"
#include "engine/error.h"
#include "engine/pass/stop.h"
#include "engine/report/product_files.h"
#include "kernels/core/parallel.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/folder_server.h"
#include "tools/ilot/opener.h"

namespace ilot {
namespace {

struct ViewArguments {
  std::string folder;
  int port = 0;
  bool no_browser = false;
};

void open_browser(const std::string& address) {
  const std::string program = browser_opener();
  std::string name = "xdg-open", target = address;
  char* const arguments[] = {name.data(), target.data(), nullptr};
  pid_t child = 0;
  if (program.empty() || posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ) != 0)
    say("ilot: there is no xdg-open to start a browser with; open the address above yourself\n");
}

int view_command(const ViewArguments& given) {
  if (given.folder.empty()) throw Error("view: no OUT given (ilot view --help)", ExitCode::usage);
  const std::filesystem::path folder = given.folder;
  if (!std::filesystem::exists(folder / kReportFile)) with_threads(hardware_threads(), [&] { write_report(folder); });
  const FolderServer server(folder, static_cast<std::uint16_t>(given.port));
  const std::string address = fmt::format("http://127.0.0.1:{}/{}", server.port(), kReportFile);
  print(fmt::format("serving {} at {} for this machine alone; Ctrl+C ends it\n", folder.string(), address));
  if (!given.no_browser) open_browser(address);
  server.serve([] { return stop_requested(); });
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_view_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("view", "Opens the report of a result in the browser");
  auto given = std::make_shared<ViewArguments>();
  command->add_option("OUT", given->folder, "the folder that a run has written")->option_text(" ");
  command->add_option("--port", given->port, "of the loopback address [any that is free]")
      ->check(CLI::Range(0, 65535))
      ->option_text("N");
  command->add_flag("--no-browser", given->no_browser, "only serve, and print the address [off]");
  command->footer("Example: ilot view out");
  command->callback([given, &action] { action = [given] { return view_command(*given); }; });
}

}  // namespace ilot
