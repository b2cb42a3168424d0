// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "engine/error.h"
#include "engine/evaluate/validate_las.h"
#include "engine/run/inputs.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

struct ValidateArguments {
  std::vector<std::string> inputs;
  bool quiet = false;
};

std::vector<Finding> findings_of(const std::filesystem::path& file, bool quiet) {
  ConsoleProgress progress(quiet ? Verbosity::quiet : Verbosity::normal, "");
  try {
    const auto reader = open_cloud(file);
    progress.get().begin_stage(file.filename().string(), reader->info().points);
    auto findings = validate_las(*reader, [&](std::uint64_t n) { progress.get().advance(n); });
    progress.get().clear_line();
    return findings;
  } catch (const Error& fault) {
    progress.get().clear_line();
    if (fault.code() != ExitCode::failed) throw;
    return {{"unreadable", fault.what(), true}};
  }
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  }
  return text + "\n";
}

// True when nothing is severe.
bool print_findings(const std::filesystem::path& file, const std::vector<Finding>& findings) {
  bool valid = true;
  for (const Finding& finding : findings) {
    print(one_line(
        fmt::format("{}: {}: {}: {}", file.string(), finding.severe ? "invalid" : "note", finding.rule, finding.text)));
    valid = valid && !finding.severe;
  }
  if (valid) print(one_line(file.string() + ": valid"));
  return valid;
}

// One line per finding, one for a file without severe ones; all files are looked at, those of other formats named.
int validate_command(const ValidateArguments& given) {
  if (given.inputs.empty()) throw Error("validate: no FILE given (ilot validate --help)", ExitCode::usage);
  bool all_valid = true, all_judged = true;
  for (const auto& file : expand_inputs(given.inputs)) {
    try {
      all_valid = print_findings(file, findings_of(file, given.quiet)) && all_valid;
    } catch (const Error& fault) {
      if (fault.code() != ExitCode::usage) throw;
      say(one_line(std::string("ilot: ") + fault.what()));
      all_judged = false;
    }
  }
  if (!all_valid) return static_cast<int>(ExitCode::failed);
  return static_cast<int>(all_judged ? ExitCode::ok : ExitCode::usage);
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("validate", "Checks LAS and LAZ files: headers against points");
  auto given = std::make_shared<ValidateArguments>();
  command->add_option("FILE", given->inputs, "LAS and LAZ files, folders, patterns")->option_text("...");
  command->add_flag("-q,--quiet", given->quiet, "no progress [off]");
  command->footer("Exit codes: 0 all valid, 1 one is not, 2 usage.\nExample: ilot validate district.las");
  command->callback([given, &action] { action = [given] { return validate_command(*given); }; });
}

}  // namespace ilot
