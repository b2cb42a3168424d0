// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/replay/replay.h"
#include "engine/run/inputs/read_area.h"
#include "kernels/core/parallel.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/render/plot.h"
#include "training/object_model_training.h"

namespace ilot {
namespace {

struct ReplayArguments {
  std::string out, unit, folder, store, stations, within;
  std::vector<std::string> edits;
  int threads = 0, size = 1200;
  bool list = false, all = false, quiet = false;
};

int list_units(const KeptRunPlaces& places, bool all) {
  constexpr std::size_t kShown = 50;
  const std::vector<std::string> units = units_to_replay(places);
  std::string text;
  for (std::size_t i = 0; i < units.size() && (all || i < kShown); ++i) text += units[i] + "\n";
  print(text + grouped(units.size()) + (units.size() == 1 ? " unit" : " units") +
        (all || units.size() <= kShown ? "\n" : ", the first 50 are shown; --all shows the others\n"));
  return static_cast<int>(ExitCode::ok);
}

int replay_unit(const ReplayArguments& given, const KeptRunPlaces& places, Progress& progress) {
  ReplayResult result;
  with_threads(given.threads > 0 ? given.threads : hardware_threads(), [&] {
    result = replay({places, given.unit, given.folder}, progress);
  });
  for (const Picture& picture : result.pictures)
    render::write_png(render::plot(picture, given.size), result.folder / (picture.name + ".png"));
  if (result.differences.empty()) {
    progress.note(result.folder.string() + ": steps.gpkg and " + std::to_string(result.pictures.size()) +
                  " pictures; the unit is as the run wrote it");
    return static_cast<int>(ExitCode::ok);
  }
  for (const std::string& difference : result.differences) progress.warn(given.unit + ": " + difference);
  return static_cast<int>(ExitCode::incomplete);
}

int replay_command(const ReplayArguments& given) {
  if (given.out.empty())
    throw Error("replay: OUT, the folder of a run, is needed (ilot replay --help)", ExitCode::usage);
  if (given.unit.empty() != given.list)
    throw Error("replay: give a UNIT or --list (ilot replay --help)", ExitCode::usage);
  ConsoleProgress progress(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  KeptRunPlaces places{given.out, given.store, given.stations, {given.edits.begin(), given.edits.end()}, {}, {}};
  if (!given.within.empty()) places.within = read_area(given.within);
  places.learn = [](std::span<const TrainingSample> samples) { return train_object_model(samples); };
  return given.list ? list_units(places, given.all) : replay_unit(given, places, progress.get());
}

}  // namespace

void add_replay_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("replay", "Shows every step of one unit of a run that kept its store");
  auto given = std::make_shared<ReplayArguments>();
  command->add_option("OUT", given->out, "the folder of a run with --keep-store")->option_text(" ");
  command
      ->add_option("UNIT", given->unit,
                   "building:ID, facade:N, tile:ROW,COLUMN, tile:at:E,N, cell:X,Y,Z or cell:at:E,N,H")
      ->option_text(" ");
  command->add_option("-o,--output", given->folder, "folder for what is written [OUT/replay/UNIT]")
      ->option_text("FOLDER");
  command->add_flag("--list", given->list, "print the units with their places and sizes, the first 50 [off]");
  command->add_flag("--all", given->all, "with --list: all of them [off]");
  command->add_option("--store", given->store, "the kept store, where the run had --store [OUT/.store]")
      ->option_text("DIR");
  command->add_option("--stations", given->stations, "as the run was given it [as inputs say]")->option_text("FILE");
  command->add_option("--edits", given->edits, "as the run was given it, once for each table [none]")
      ->option_text("FILE");
  command->add_option("--within", given->within, "as the run was given it [everything]")->option_text("FILE");
  command->add_option("--size", given->size, "pixels of the longer side of pictures [1200]")
      ->option_text("N")
      ->check(CLI::Range(64, 8192));
  command->add_option("--threads", given->threads, "1 to 1024 threads [all]")
      ->option_text("N")
      ->check(CLI::Range(1, 1024));
  command->add_flag("-q,--quiet", given->quiet, "say only what is wrong [off]");
  command->footer("Example: ilot replay out building:718 -o look");
  command->callback([given, &action] { action = [given] { return replay_command(*given); }; });
}

}  // namespace ilot
