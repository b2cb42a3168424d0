// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "scan/models/model_scan.h"
#include "scan/scanners/stations_file.h"
#include "scan/scenes.h"
#include "scan/truth_writer.h"
#include "scan/wild/distributions.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

struct ScanArguments {
  std::string scene, output;
  std::optional<std::uint64_t> points;
  std::uint64_t seed = 0;
  int threads = 0;
  std::vector<std::string> settings, without;
  bool list = false, overwrite = false, quiet = false;
  scan::ModelInput model;
  std::string up = "z";
  std::vector<std::string> stations, vehicle;  // with the name of a file or without
  bool with_stations = false, with_vehicle = false, with_flight = false;
};

scan::ScanRequest make_request(const ScanArguments& given, std::string_view scene,
                               std::span<const scan::SceneOption> options, std::span<const std::string_view> groups) {
  if (given.output.empty()) throw Error("scan: -o FILE is needed (ilot scan --help)", ExitCode::usage);
  scan::ScanRequest request{scene, scan::SceneValues(options), given.seed, given.points, given.output};
  for (const std::string& setting : given.settings) request.values.set(setting);
  const std::vector<std::string_view> families = scan::families_of(groups);
  for (const std::string& names : given.without) request.values.leave_out(names, families);
  return request;
}

std::string summary_text(const std::string& output, const scan::ScanCounts& counts) {
  std::string text = output + ":";
  for (std::size_t i = 0; i < counts.size(); ++i)
    text += fmt::format("{} {} {}", i ? "," : "", counts[i].second, counts[i].first);
  return text;
}

void check_output(const ScanArguments& given) {
  std::error_code code;
  const std::filesystem::path truth = scan::truth_path(given.output);
  const auto model = [&](const char* extension) { return std::filesystem::path(truth).replace_extension(extension); };
  for (const auto& path : {std::filesystem::path(given.output), truth, model(".city.json"), model(".city.jsonl"),
                           scan::stations_path(given.output)})
    if (!given.overwrite && std::filesystem::exists(path, code))
      throw Error(path.string() + ": exists; --overwrite replaces it", ExitCode::usage);
}

void check_no_model_options(const ScanArguments& given) {
  const bool any = given.with_stations || given.with_vehicle || given.with_flight || !given.model.lod.empty() ||
                   !given.model.crs.empty() || !given.model.unit.empty() || given.up != "z";
  if (any)
    throw Error("scan: --stations, --vehicle, --flight, --lod, --crs, --unit and --up belong to --model FILE",
                ExitCode::usage);
}

scan::ScanCounts scan_model_file(const ScanArguments& given, const scan::ScanRequest& request, Progress& progress) {
  scan::ModelInput input = given.model;
  input.y_up = given.up == "y";
  const auto file_of = [](bool wanted, const std::vector<std::string>& names) {
    std::optional<std::filesystem::path> file;
    if (wanted) file = names.empty() ? std::string() : names[0];
    return file;
  };
  const scan::ModelScanners scanners{file_of(given.with_stations, given.stations),
                                     file_of(given.with_vehicle, given.vehicle), given.with_flight};
  scan::ModelScan scan = scan::plan_model_scan(input, scanners, request.values, request.seed);
  for (const std::string& note : scan.notes) progress.note(note);
  return scan::write_model_scan(scan, input, request);
}

int scan_command(const ScanArguments& given) {
  if (given.list) {
    print(scan::list_scenes());
    return static_cast<int>(ExitCode::ok);
  }
  const bool model = !given.model.path.empty();
  if (model && !given.scene.empty())
    throw Error("scan: SCENE and --model contradict each other; leave out one", ExitCode::usage);
  if (!model) check_no_model_options(given);
  if (!model && given.scene.empty())
    throw Error("scan: SCENE (ilot scan --list) or --model FILE is needed", ExitCode::usage);
  const scan::Scene* scene = model ? nullptr : &scan::find_scene(given.scene);
  scan::ScanRequest request = model ? make_request(given, "", scan::model_options(), {})
                                    : make_request(given, scene->name, scene->options, scene->groups);
  check_output(given);
  ConsoleProgress console(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  Progress& progress = console.get();
  progress.begin_stage("scan", given.points.value_or(0));
  request.written = [&](std::uint64_t points) { progress.advance(points); };
  scan::ScanCounts counts;
  with_threads(given.threads > 0 ? given.threads : hardware_threads(),
               [&] { counts = model ? scan_model_file(given, request, progress) : scene->scan(request); });
  progress.end_stage();
  progress.note(summary_text(given.output, counts));
  if (scene && !scene->groups.empty())
    progress.note("drawn from distributions.csv, sha256 " + scan::distributions_hash());
  return static_cast<int>(ExitCode::ok);
}

void add_model_options(CLI::App& command, ScanArguments& given) {
  command.add_option("--model", given.model.path, "scan this model in place of a scene: CityJSON or OBJ [none]")
      ->option_text("FILE");
  command
      .add_option("--stations", given.stations,
                  "scan the model from tripods at these places: name,x,y,z [around each building]")
      ->option_text("[FILE]")
      ->expected(0, 1);
  command
      .add_option("--vehicle", given.vehicle,
                  "scan it from a vehicle along these places of its heads: x,y,z [once around the model]")
      ->option_text("[FILE]")
      ->expected(0, 1);
  command.add_flag("--flight", given.with_flight, "scan it from flight lines over it [off]");
  command.add_option("--lod", given.model.lod, "level of detail of a CityJSON, such as 2 or 2.2 [the highest]")
      ->option_text("L");
  command.add_option("--crs", given.model.crs, "coordinate system of the model, EPSG:n [as the model says]")
      ->option_text("CRS");
  command.add_option("--unit", given.model.unit, "unit of the model: m, ft, us-ft, cm or mm [by its CRS, else m]")
      ->option_text("U");
  command.add_option("--up", given.up, "axis of an OBJ that points up: z or y [z]")
      ->option_text("A")
      ->check(CLI::IsMember({"z", "y"}));
}

}  // namespace

void add_scan_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("scan", "Makes a point cloud with exact truth: a virtual scanner");
  auto given = std::make_shared<ScanArguments>();
  command->add_option("SCENE", given->scene, "one of --list, where there is no --model")->option_text(" ");
  add_model_options(*command, *given);
  command->add_option("-o,--output", given->output, "point cloud to write; NAME.truth.json goes beside it [none]")
      ->option_text("FILE");
  command->add_option("--points", given->points, "how many; --list says how each scene meets it [by the scene]")
      ->option_text("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000'000}));
  command->add_option("--seed", given->seed, "another seed, another scan [0]")->option_text("S");
  command->add_option("--threads", given->threads, "no result depends on it [all]")
      ->option_text("N")
      ->check(CLI::Range(1, 1024));
  command->add_option("--set", given->settings, "one option of the scene, see --list [none]")
      ->option_text("scene.KEY=VALUE")
      ->take_all();
  command->add_option("--without", given->without, "families of forms that a wild scene leaves out, see --list [none]")
      ->option_text("FAMILY,...")
      ->take_all();
  command->add_flag("--list", given->list, "list the scenes and what can be set about them [off]");
  command->add_flag("--overwrite", given->overwrite, "replace FILE and its truth [off]");
  command->add_flag("-q,--quiet", given->quiet, "say only what is wrong [off]");
  command->footer(
      "Example: ilot scan district -o town.las --points 1000000 --set scene.density=20\n"
      "Example: ilot scan --model house.city.json -o house.laz --stations --flight --set scene.glass_nothing=1");
  command->callback([given, command, &action] {
    given->with_stations = command->count("--stations") > 0;
    given->with_vehicle = command->count("--vehicle") > 0;
    action = [given] { return scan_command(*given); };
  });
}

}  // namespace ilot
