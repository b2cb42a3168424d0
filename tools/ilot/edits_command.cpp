// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/compare/facades/drawing_edits.h"
#include "engine/deliverables/tables/edits_csv.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/error.h"
#include "engine/report/counted.h"
#include "engine/run/inputs/read_edits.h"
#include "engine/whole_file.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

struct EditsArguments {
  std::vector<std::string> drawings, training;
  std::string output, facade, layers = "ilot";
};

// The plan of a facade stands beside its drawing, under the same name.
std::filesystem::path facade_of(const EditsArguments& given) {
  if (!given.facade.empty()) return given.facade;
  std::filesystem::path plan = given.drawings[0];
  plan.replace_extension(".json");
  if (!std::filesystem::exists(plan))
    throw Error(given.drawings[0] + ": no " + plan.filename().string() +
                    " beside it says where the facade is; --facade names the facade-NNN.json of the run",
                ExitCode::usage);
  return plan;
}

std::string counts_of(const std::vector<Edit>& edits) {
  std::string text;
  for (std::size_t i = 0; i < kEditActionNames.size(); ++i) {
    const auto of_action = std::count_if(edits.begin(), edits.end(),
                                         [&](const Edit& e) { return static_cast<std::size_t>(e.action) == i; });
    if (of_action == 0) continue;
    const std::string name =
        static_cast<EditAction>(i) == EditAction::kind ? "of another kind" : kEditActionNames.at(i);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", of_action, name);
  }
  return text.empty() ? "nothing is changed" : text;
}

// The places of objects whose class the edits of streets say, for ilot run --train.
int write_training(const EditsArguments& given) {
  const std::vector<std::filesystem::path> tables(given.training.begin(), given.training.end());
  std::string places = "WKT,class\n";
  std::uint64_t count = 0;
  for (const Edit& edit : read_edits(tables)) {
    const std::string name = edit.action == EditAction::deleted ? "none"
                             : edit.action == EditAction::added ? edit.kind
                                                                : edit.to_kind;
    if (edit.product != "streets" || name.empty()) continue;
    places += fmt::format("POINT ({:.4f} {:.4f}),{}\n", edit.at[0].x, edit.at[0].y, name);
    ++count;
  }
  if (count == 0) throw Error(given.training[0] + ": no edit of streets says a class", ExitCode::usage);
  write_whole_file(given.output, places);
  print(fmt::format("{}: {}\n", given.output, counted(count, "place")));
  return static_cast<int>(ExitCode::ok);
}

int edits_command(const EditsArguments& given) {
  if (given.drawings.size() != 2 && given.training.empty())
    throw Error("edits: --from-drawing OURS.dxf THEIRS.dxf or --training TABLE is needed", ExitCode::usage);
  if (given.output.empty()) throw Error("edits: -o FILE is needed", ExitCode::usage);
  if (!given.training.empty()) return write_training(given);
  const Facade facade = read_facade_json(facade_of(given));
  const DrawingEdits found =
      drawing_edits(read_dxf(given.drawings[0]), read_dxf(given.drawings[1]), facade, read_layers(given.layers));
  write_whole_file(given.output, edits_csv(found.edits));
  print(fmt::format("{}: {}; {} as they were\n", given.output, counts_of(found.edits),
                    counted(found.unchanged, "opening")));
  if (found.loose > 0)
    say(fmt::format("ilot: {}: {} on the layer of openings close no outline and are left out; draw closed lines\n",
                    given.drawings[1], counted(found.loose, "line")));
  return static_cast<int>(found.loose > 0 ? ExitCode::incomplete : ExitCode::ok);
}

}  // namespace

void add_edits_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("edits", "Makes a table of edits from a corrected drawing, or places for training from edits");
  auto given = std::make_shared<EditsArguments>();
  command
      ->add_option("--from-drawing", given->drawings,
                   "facade-NNN.dxf of a run, and the same as it was corrected [none]")
      ->option_text("OURS.dxf THEIRS.dxf")
      ->expected(2);
  command
      ->add_option(
          "--training", given->training,
          "tables of edits: writes the places of street objects whose class they say, for ilot run --train [none]")
      ->option_text("TABLE")
      ->excludes("--from-drawing");
  command
      ->add_option("-o,--output", given->output,
                   "the table, CSV, for ilot run --edits, or the places for ilot run --train [none]")
      ->option_text("FILE");
  command->add_option("--facade", given->facade, "the plan of the facade [facade-NNN.json beside OURS.dxf]")
      ->option_text("FACADE.json");
  command->add_option("--layers", given->layers, "of both drawings: ilot, aia, iso13567 or a mapping file [ilot]")
      ->option_text("NAME");
  command->footer(
      "Example: ilot edits --from-drawing out/facades/facade-001.dxf corrected.dxf -o edits.csv\n"
      "Then: ilot run CLOUD -o out2 --products facades --edits edits.csv");
  command->callback([given, &action] { action = [given] { return edits_command(*given); }; });
}

}  // namespace ilot
