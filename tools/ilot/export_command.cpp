// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "engine/deliverables/exports/export_result.h"
#include "engine/error.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

struct ExportArguments {
  std::string result, folder;
  ExportParams params;
};

int export_command(const ExportArguments& given) {
  if (given.result.empty()) throw Error("export: no OUT given (ilot export --help)", ExitCode::usage);
  if (given.params.formats.empty()) throw Error("export: --to FORMAT is needed (ilot export --help)", ExitCode::usage);
  if (given.folder.empty()) throw Error("export: -o FOLDER is needed", ExitCode::usage);
  const ExportSummary summary = export_result(given.result, given.folder, given.params);
  for (const std::string& note : summary.notes) say(one_line("ilot: " + note));
  const auto& formats = given.params.formats;
  const bool solids = std::any_of(formats.begin(), formats.end(), [](const auto& f) { return f != "citygml"; });
  if (summary.without_model > 0 && solids)
    say(fmt::format("ilot: {} of {} buildings have no solid and are left out of all formats but citygml\n",
                    summary.without_model, summary.buildings));
  return static_cast<int>(ExitCode::ok);
}

std::string formats_text() {
  std::string text = "Formats:";
  for (const ExportFormat& format : export_formats()) text += fmt::format("\n  {:<9} {}", format.name, format.meaning);
  return text + "\n";
}

}  // namespace

void add_export_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("export", "Writes a finished result in the formats of other programs");
  auto given = std::make_shared<ExportArguments>();
  command->add_option("OUT", given->result, "the folder that a run has written")->option_text(" ");
  command->add_option("--to", given->params.formats, "formats, below, with commas between them")
      ->option_text("FORMAT,...")
      ->delimiter(',');
  command->add_option("-o,--output", given->folder, "a new folder for the files")->option_text("FOLDER");
  command->add_option("--crs", given->params.crs, "of the coordinates [as the result says]")->option_text("EPSG:n");
  command->add_option("--geoid-height", given->params.geoid_m, "3dtiles: metres that are added to heights [0]")
      ->option_text("M")
      ->check(CLI::Range(-200.0, 200.0));
  command->footer(formats_text() + "Example: ilot export out --to glb,ply -o models");
  command->callback([given, &action] { action = [given] { return export_command(*given); }; });
}

}  // namespace ilot
