// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/error.h"
#include "engine/report/allowed_memory.h"
#include "engine/run/inputs/inputs.h"
#include "engine/run/inputs/read_area.h"
#include "engine/run/run.h"
#include "engine/settings/config.h"
#include "engine/settings/parameters.h"
#include "kernels/core/parallel.h"
#include "tools/ilot/allocator.h"
#include "tools/ilot/asked_products.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/units.h"
#include "training/object_model_training.h"

namespace ilot {
namespace {

constexpr std::uint64_t kLeastMemory = 96u << 20, kUsualMemory = std::uint64_t{2} << 30;

// The options as the user gave them.
struct RunArguments {
  std::vector<std::string> inputs, products{"planes"}, assignments, edits;
  std::string output, config, memory, store, bounds, within, footprints, id_field, stations, train, crs, to_crs,
      dialect, log;
  int threads = 0;
  std::uint64_t block_points = 0;
  bool resume = false, overwrite = false, strict = false, dry_run = false, keep_store = false, no_clouds = false,
       no_report = false;
  bool print_config = false, verbose = false, quiet = false;
};

Settings settings_of(const RunArguments& given) {
  Settings settings;
  if (!given.config.empty()) load_config(settings, given.config);
  for (const std::string& assignment : given.assignments) apply_assignment(settings, assignment);
  if (given.block_points > 0) {
    const Parameter& parameter = *find_parameter("index.block_points");
    const Value value = static_cast<std::int64_t>(std::min(given.block_points, std::uint64_t{1} << 62));
    if (auto problem = check_value(parameter, value)) throw Error("--block-points: " + *problem, ExitCode::usage);
    parameter.set(settings, value);
  }
  return settings;
}

// Returns half of the memory that the machine or its control group allows, because other programs need memory too. The
// usual amount is the maximum.
std::uint64_t memory_of(const RunArguments& given) {
  if (given.memory.empty()) return std::clamp(allowed_memory_bytes() / 2, kLeastMemory, kUsualMemory);
  const std::uint64_t bytes = parse_bytes("--memory", given.memory);
  if (bytes < kLeastMemory) throw Error("--memory: at least 96M is needed", ExitCode::usage);
  return bytes;
}

RunOptions options_of(const RunArguments& given) {
  RunOptions options;
  options.settings = settings_of(given);
  options.products = asked_products(given.products);
  options.footprints = given.footprints;
  options.id_field = given.id_field;
  options.stations = given.stations;
  options.train = given.train;
  options.edits.assign(given.edits.begin(), given.edits.end());
  if (given.inputs.empty()) throw Error("run: no INPUT given (ilot run --help)", ExitCode::usage);
  if (given.output.empty()) throw Error("run: no output folder given: -o OUT (ilot run --help)", ExitCode::usage);
  options.output = given.output;
  options.memory_bytes = memory_of(given);
  options.threads = given.threads;
  options.store = given.store;
  options.crs = parse_crs("--crs", given.crs);
  options.to_crs = given.to_crs == "utm" ? given.to_crs : parse_crs("--to-crs", given.to_crs);
  options.dialect = open_options(given.dialect).dialect;
  if (!given.bounds.empty()) options.area = parse_bounds(given.bounds);
  if (!given.within.empty()) options.area = read_area(given.within);
  if (given.resume) options.existing = Existing::resume;
  if (given.overwrite) options.existing = Existing::overwrite;
  options.strict = given.strict;
  options.dry_run = given.dry_run;
  options.keep_store = given.keep_store;
  options.clouds = !given.no_clouds;
  options.report = !given.no_report;
  options.inputs = expand_inputs(given.inputs);
  return options;
}

int run_command(const RunArguments& given) {
  if (given.print_config) {
    print(print_config(settings_of(given)));
    return 0;
  }
  const RunOptions options = options_of(given);
  const Verbosity verbosity = given.quiet ? Verbosity::quiet : (given.verbose ? Verbosity::verbose : Verbosity::normal);
  ConsoleProgress progress(verbosity, given.log);
  let_allocator_keep(options.memory_bytes, options.threads);
  return run(options, progress.get(),
             [](std::span<const TrainingSample> samples) { return train_object_model(samples); });
}

void add_work_options(CLI::App& command, RunArguments& given) {
  command.add_option("INPUT", given.inputs, "point clouds: files, folders, patterns, URLs")->option_text("...");
  command.add_option("-o,--output", given.output, "folder for the results, must not exist [none]")->option_text("OUT");
  command
      .add_option("--products", given.products,
                  "what to make, comma separated: planes, roofs, facades, streets [planes]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("LIST");
  command.add_option("--config", given.config, "settings as TOML, --print-config shows all [none]")
      ->option_text("FILE");
  command.add_option("--set", given.assignments, "one setting, after --config; repeatable [none]")
      ->allow_extra_args(false)
      ->option_text("KEY=VALUE");
  auto* bounds =
      command.add_option("--bounds", given.bounds, "products in this box only, units of the CRS [everything]");
  bounds->option_text("X0,Y0,X1,Y1");
  command.add_option("--within", given.within, "products in these polygons only, GeoJSON or WKT [everything]")
      ->excludes(bounds)
      ->option_text("FILE");
  command.add_option("--footprints", given.footprints, "outlines of buildings, any vector file, for roofs [none]")
      ->option_text("FILE");
  command.add_option("--id-field", given.id_field, "attribute that names the footprints [identificatie, id ...]")
      ->option_text("NAME");
  command.add_option("--stations", given.stations, "where scanners stood and how they turned, text [as inputs say]")
      ->option_text("FILE");
  command
      .add_option(
          "--train", given.train,
          "objects of streets with their class, any names, vector file, truth or objects.model, for streets [none]")
      ->option_text("FILE");
  command.add_option("--edits", given.edits, "corrections by hand, a table (CSV); repeatable [none]")
      ->allow_extra_args(false)
      ->option_text("FILE");
  command.add_option("--crs", given.crs, "overrides what the inputs say [theirs]")->option_text("EPSG:n");
  command
      .add_option("--to-crs", given.to_crs,
                  "moves the coordinates to this CRS first, utm: to the zone they are in [off]")
      ->option_text("EPSG:n|utm");
  add_dialect_option(command, given.dialect);
}

void add_machine_options(CLI::App& command, RunArguments& given) {
  command
      .add_option(
          "--memory", given.memory,
          "upper bound of resident memory, with K, M, G or T [2G, at most half of what machine or cgroup allow]")
      ->option_text("BYTES");
  command
      .add_option("--threads", given.threads, "1 to 1024 threads; at most one for each 24 MiB of --memory work [all]")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  command.add_option("--block-points", given.block_points, "256 to 67108864 points per block of the store [1048576]")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62))
      ->option_text("N");
  command.add_option("--store", given.store, "folder for the block store [OUT/.store]")->option_text("DIR");
  command.add_flag("--keep-store", given.keep_store, "leave the block store behind [off]");
  command.add_flag("--no-clouds", given.no_clouds, "do not write the inputs again with labels [off]");
  command.add_flag("--no-report", given.no_report, "do not write report.html, the result on one page [off]");
}

void add_manner_options(CLI::App& command, RunArguments& given) {
  auto* resume = command.add_flag("--resume", given.resume, "go on with an interrupted run in OUT [off]");
  command.add_flag("--overwrite", given.overwrite, "replace OUT [off]")->excludes(resume)->option_text(" ");
  resume->option_text(" ");
  command.add_flag("--strict", given.strict, "the first skipped file or unit ends the run, exit 1 [off]");
  command.add_flag("--dry-run", given.dry_run, "say what would be done and needed, write nothing [off]");
  command.add_flag("--print-config", given.print_config, "print all settings as TOML and stop [off]");
  auto* verbose = command.add_flag("-v,--verbose", given.verbose, "say more [off]");
  command.add_flag("-q,--quiet", given.quiet, "say only what is wrong [off]")->excludes(verbose)->option_text(" ");
  verbose->option_text(" ");
  command.add_option("--log-json", given.log, "events as JSON lines to FILE, - (standard error) or fd:N [none]")
      ->option_text("LOG");
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("run", "Makes products from point clouds");
  auto given = std::make_shared<RunArguments>();
  add_work_options(*command, *given);
  add_machine_options(*command, *given);
  add_manner_options(*command, *given);
  command->footer("Example: ilot run district.las -o out --set planes.epsilon=0.05 --memory 512M");
  command->callback([given, &action] { action = [given] { return run_command(*given); }; });
}

}  // namespace ilot
