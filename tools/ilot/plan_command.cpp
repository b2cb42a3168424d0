// SPDX-License-Identifier: Apache-2.0
// ilot plan, ilot task and ilot merge: one result from many processes.
#include <charconv>
#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/run/inputs/inputs.h"
#include "engine/scale/make_plan.h"
#include "engine/scale/merge/merge.h"
#include "engine/scale/plan_scripts.h"
#include "engine/scale/run_task.h"
#include "engine/settings/config.h"
#include "engine/settings/parameters.h"
#include "tools/ilot/allocator.h"
#include "tools/ilot/asked_products.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/units.h"

namespace ilot {
namespace {

constexpr std::uint64_t kLeastOfTask = 96u << 20;

struct PlanArguments {
  std::vector<std::string> inputs, products{"roofs"}, assignments;
  std::string output, config, memory, store, footprints, id_field, crs, dialect, area_size = "auto", kind;
  std::string update, statistics, stations, parts;
  int threads = 0;
  bool labels = false, estimate = false, quiet = false;
};

std::uint64_t memory_of(const std::string& text) {
  if (text.empty()) return std::uint64_t{512} << 20;
  const std::uint64_t bytes = parse_bytes("--memory", text);
  if (bytes < kLeastOfTask) throw Error("--memory: at least 96M is needed", ExitCode::usage);
  return bytes;
}

double area_size_of(const std::string& text) {
  if (text == "auto") return 0;
  std::size_t used = 0;
  double size = 0;
  try {
    size = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || !(size >= 1 && size <= 1e6))
    throw Error("--area-size " + text + ": must be auto or 1 to 1000000 metres", ExitCode::usage);
  return size;
}

PlanOptions options_of(const PlanArguments& given) {
  PlanOptions options;
  RunOptions& run = options.run;
  if (!given.config.empty()) load_config(run.settings, given.config);
  for (const std::string& assignment : given.assignments) apply_assignment(run.settings, assignment);
  run.products = asked_products(given.products);
  run.footprints = given.footprints;
  run.id_field = given.id_field;
  run.stations = given.stations;
  run.output = given.output;
  run.memory_bytes = memory_of(given.memory);
  run.threads = given.threads;
  run.store = given.store;
  run.crs = parse_crs("--crs", given.crs);
  run.dialect = open_options(given.dialect).dialect;
  run.clouds = false;
  options.area_size = area_size_of(given.area_size);
  if (!given.inputs.empty()) run.inputs = expand_inputs(given.inputs);
  options.statistics = given.statistics;
  options.update = given.update;
  options.labels = given.labels;
  options.parts = given.parts;
  return given.update.empty() ? options : options_of_update(std::move(options));
}

int plan_command(const PlanArguments& given) {
  const bool reads = given.estimate || !given.kind.empty();
  if (given.inputs.empty() && given.update.empty())
    throw Error("plan: no INPUT given (ilot plan --help)", ExitCode::usage);
  if (given.output.empty() && reads) {
    if (given.inputs.size() != 1 || !given.update.empty())
      throw Error("plan: --as and --estimate read one PLAN (ilot plan --help)", ExitCode::usage);
    print(given.kind.empty() ? plan_estimate(given.inputs[0]) + "\n" : plan_script(given.inputs[0], given.kind));
    return 0;
  }
  if (given.output.empty()) throw Error("plan: no folder given: -o PLAN (ilot plan --help)", ExitCode::usage);
  if (reads) throw Error("plan: --as and --estimate read a finished PLAN: leave -o out", ExitCode::usage);
  const PlanOptions options = options_of(given);
  let_allocator_keep(options.run.memory_bytes, options.run.threads);
  ConsoleProgress progress(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  return make_plan(options, progress.get());
}

struct TaskArguments {
  std::string plan, memory, work, output;
  std::vector<std::string> what;  // "7", or "label", "7"
  int threads = 0;
  bool quiet = false;
};

std::uint64_t number_of(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size() || number == 0)
    throw Error("task " + text + ": must be a whole number from 1", ExitCode::usage);
  return number;
}

int task_command(const TaskArguments& given) {
  if (given.plan.empty()) throw Error("task: no PLAN given (ilot task --help)", ExitCode::usage);
  const bool label = given.what.size() == 2;
  if (given.what.empty()) throw Error("task: no area given: N from 1 (ilot task --help)", ExitCode::usage);
  if (label && given.what[0] != "label")
    throw Error("task " + given.what[0] + ": must be a number, or label and a number", ExitCode::usage);
  if (label == given.output.empty())
    throw Error("task: -o OUT belongs to label N, which writes a cloud to OUT/points (ilot task --help)",
                ExitCode::usage);
  if (label && !given.work.empty())
    throw Error("task: --work is for areas; label N writes beside its cloud, in OUT", ExitCode::usage);
  ConsoleProgress progress(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  const std::uint64_t memory = memory_of(given.memory);
  let_allocator_keep(memory, given.threads);
  return run_task({.plan = given.plan,
                   .number = number_of(given.what.back()),
                   .memory_bytes = memory,
                   .threads = given.threads,
                   .work = given.work,
                   .label = label,
                   .output = given.output},
                  progress.get());
}

struct MergeArguments {
  std::string plan, output, memory;
  int threads = 0;
  bool allow_missing = false, no_report = false, labels = false, quiet = false;
};

int merge_command(const MergeArguments& given) {
  if (given.plan.empty()) throw Error("merge: no PLAN given (ilot merge --help)", ExitCode::usage);
  if (given.output.empty()) throw Error("merge: no output folder given: -o OUT (ilot merge --help)", ExitCode::usage);
  ConsoleProgress progress(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  const std::uint64_t memory = memory_of(given.memory);
  let_allocator_keep(memory, given.threads);
  return merge_parts(
      {given.plan, given.output, given.allow_missing, !given.no_report, given.labels, memory, given.threads},
      progress.get());
}

void add_machine_options(CLI::App& command, std::string& memory, int& threads) {
  command.add_option("--memory", memory, "upper bound of resident memory, with K, M, G or T [512M]")
      ->option_text("BYTES");
  command.add_option("--threads", threads, "1 to 1024 threads [all]")->check(CLI::Range(1, 1024))->option_text("N");
}

void add_plan_work(CLI::App& command, PlanArguments& given) {
  command.add_option("INPUT", given.inputs, "point clouds, as for ilot run; with --as and --estimate a PLAN")
      ->option_text("...");
  command.add_option("-o,--output", given.output, "folder for the plan, must not exist [none]")->option_text("PLAN");
  command.add_option("--products", given.products, "what to make: any of roofs, planes, facades, streets [roofs]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("LIST");
  command.add_option("--area-size", given.area_size, "side of an area in metres [auto: ten million points]")
      ->option_text("auto|METRES");
  command.add_option("--config", given.config, "settings as TOML [none]")->option_text("FILE");
  command.add_option("--set", given.assignments, "one setting, after --config; repeatable [none]")
      ->allow_extra_args(false)
      ->option_text("KEY=VALUE");
  command.add_option("--footprints", given.footprints, "outlines of buildings, any vector file [found in the cloud]")
      ->option_text("FILE");
  command.add_option("--id-field", given.id_field, "attribute that names the footprints [identificatie, id ...]")
      ->option_text("NAME");
  command.add_option("--stations", given.stations, "places of the scanners, as for ilot run [those in the inputs]")
      ->option_text("FILE");
  command.add_option("--crs", given.crs, "overrides what the inputs say [theirs]")->option_text("EPSG:n");
  add_dialect_option(command, given.dialect);
  command
      .add_option("--store", given.store,
                  "folder for blocks, of roofs without footprints alone; is emptied [PLAN/.store]")
      ->option_text("DIR");
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("plan", "Cuts a run into areas that many machines can work on");
  auto given = std::make_shared<PlanArguments>();
  add_plan_work(*command, *given);
  add_machine_options(*command, given->memory, given->threads);
  command
      ->add_option("--update", given->update,
                   "a plan of the same run: only areas whose inputs changed are left to do; INPUT as there if none is "
                   "given [none]")
      ->option_text("OLD");
  command
      ->add_option("--statistics", given->statistics,
                   "a plan whose values of auto are kept, as --update does, with all areas to do [none]")
      ->option_text("OLD");
  command
      ->add_option("--parts", given->parts,
                   "where tasks write their parts in an object store, s3://, gs:// or az:// [PLAN/parts]")
      ->option_text("URL");
  command->add_flag("--labels", given->labels,
                    "parts of roofs alone have all points too, so that clouds can be labelled; those of other products "
                    "have them [off]");
  command->add_option("--as", given->kind, "print what runs PLAN: make, slurm, snakemake, dask or k8s [none]")
      ->option_text("ENGINE");
  command->add_flag("--estimate", given->estimate, "print what the tasks of PLAN need in all [off]");
  command->add_flag("-q,--quiet", given->quiet, "say only what is wrong [off]");
  for (const char* set :
       {"--products", "--area-size", "--config", "--set", "--crs", "--text-dialect", "--statistics", "--labels"})
    command->get_option("--update")->excludes(command->get_option(set));
  command->footer(
      "Example: ilot plan tiles/ -o plan --products roofs --footprints buildings.gpkg\n"
      "Example: ilot plan scans/ -o plan --products facades --stations stations.csv\n"
      "Example: ilot plan tiles/ -o plan-2 --update plan");
  command->callback([given, &action] { action = [given] { return plan_command(*given); }; });
}

void add_task_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("task", "Works on one area of a plan: PLAN/parts/N");
  auto given = std::make_shared<TaskArguments>();
  command->add_option("PLAN", given->plan, "the folder of a plan")->option_text(" ");
  command->add_option("N", given->what, "number of an area, or label and the number of an input; from 1")
      ->expected(1, 2)
      ->option_text(" ");
  command->add_option("-o,--output", given->output, "with label N: the merged result, gets the cloud [none]")
      ->option_text("OUT");
  add_machine_options(*command, given->memory, given->threads);
  command->add_option("--work", given->work, "folder for blocks while the task works [PLAN/parts]")->option_text("DIR");
  command->add_flag("-q,--quiet", given->quiet, "say only what is wrong [off]");
  command->footer(
      "Exit codes: 0 done, or done already; 1 and 2 wrong input, do not try again; 3 done, but a building has no "
      "model;\n"
      "75 the machine was at fault (disk, memory, a signal), try again.\n"
      "Example: ilot task plan 7 --threads 1\n"
      "Example: ilot task plan label 3 -o out");
  command->callback([given, &action] { action = [given] { return task_command(*given); }; });
}

void add_merge_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("merge", "Joins the parts of a plan to the result of one run");
  auto given = std::make_shared<MergeArguments>();
  command->add_option("PLAN", given->plan, "the folder of a plan whose tasks are done")->option_text(" ");
  command->add_option("-o,--output", given->output, "folder for the results, must not exist [none]")
      ->option_text("OUT");
  command->add_flag("--allow-missing", given->allow_missing, "areas without a part are holes; exit code 3 [off]");
  command->add_flag("--no-report", given->no_report, "do not write report.html [off]");
  command->add_flag("--labels", given->labels, "leave labels in PLAN for ilot task PLAN label N [off]");
  add_machine_options(*command, given->memory, given->threads);
  command->add_flag("-q,--quiet", given->quiet, "say only what is wrong [off]");
  command->footer("Example: ilot merge plan -o out");
  command->callback([given, &action] { action = [given] { return merge_command(*given); }; });
}

}  // namespace ilot
