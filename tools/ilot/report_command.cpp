// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "engine/compare/evaluation_report.h"
#include "engine/deliverables/report/report.h"
#include "engine/error.h"
#include "engine/report/product_files.h"
#include "kernels/core/parallel.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

struct ReportArguments {
  std::string folder, against, truth;
  int threads = 0;
};

int report_command(const ReportArguments& given) {
  if (given.folder.empty()) throw Error("report: no OUT given (ilot report --help)", ExitCode::usage);
  ReportAdditions additions{given.against, {}};
  if (!given.truth.empty()) {
    Evaluation evaluation = evaluate(given.folder, read_truth(given.truth), {});
    evaluation.truth = given.truth;
    additions.truth = evaluation_html(evaluation);
  }
  ReportSummary summary;
  with_threads(given.threads > 0 ? given.threads : hardware_threads(),
               [&] { summary = write_report(given.folder, additions); });
  if (!summary.viewer)
    say("ilot: built without its viewer, so the report has no view in 3D (tools/setup installs it)\n");
  print("open " + (std::filesystem::path(given.folder) / kReportFile).string() + "\n");
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("report", "Makes the page of a result again: OUT/report.html");
  auto given = std::make_shared<ReportArguments>();
  command->add_option("OUT", given->folder, "the folder that a run has written")->option_text(" ");
  command->add_option("--against", given->against, "another result: also what came, went, moved and differs [none]")
      ->option_text("OTHER");
  command->add_option("--truth", given->truth, "NAME.truth.json of a scanned scene: also the result against it [none]")
      ->option_text("FILE");
  command->add_option("--threads", given->threads, "no report depends on it [all]")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  command->footer(
      "Example: ilot report out --against out-before\n"
      "Example: ilot report out --truth town.truth.json");
  command->callback([given, &action] { action = [given] { return report_command(*given); }; });
}

}  // namespace ilot
