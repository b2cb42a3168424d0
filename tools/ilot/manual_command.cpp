// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "engine/error.h"
#include "engine/settings/nearest_name.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/manual.h"

namespace ilot {
namespace {

int print_completion(const CLI::App& app, const std::string& shell) {
  const std::vector<std::string> shells{"bash", "zsh", "fish"};
  if (shell == "bash")
    print(bash_completion(app));
  else if (shell == "zsh")
    print(zsh_completion(app));
  else if (shell == "fish")
    print(fish_completion(app));
  else
    throw Error(
        "completion: " + (shell.empty() ? std::string("no SHELL given") : shell + " is no shell with completion") +
            ": bash, zsh or fish" + did_you_mean(shell, shells),
        ExitCode::usage);
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_manual_commands(CLI::App& app, Action& action) {
  CLI::App* manual = app.add_subcommand("manual", "Prints the manual page, for man");
  manual->footer("Example: ilot manual | man -l -");
  manual->callback([&app, &action] {
    action = [&app] {
      print(manual_page(app));
      return static_cast<int>(ExitCode::ok);
    };
  });
  CLI::App* completion = app.add_subcommand("completion", "Prints the completion of a shell: bash, zsh or fish");
  auto shell = std::make_shared<std::string>();
  completion->add_option("SHELL", *shell, "bash, zsh or fish")->option_text(" ");
  completion->footer(
      "Example: source <(ilot completion bash)\nAn installation has these files where shells look for them.");
  completion->callback([&app, shell, &action] { action = [&app, shell] { return print_completion(app, *shell); }; });
}

}  // namespace ilot
