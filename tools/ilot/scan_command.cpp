// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/error.h"
#include "kernels/core/parallel.h"
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
};

scan::ScanRequest make_request(const ScanArguments& given, const scan::Scene& scene) {
  if (given.output.empty()) throw Error("scan: -o FILE is needed (ilot scan --help)", ExitCode::usage);
  scan::ScanRequest request{scene.name, scan::SceneValues(scene.options), given.seed, given.points, given.output};
  for (const std::string& setting : given.settings) request.values.set(setting);
  const std::vector<std::string_view> families = scan::families_of(scene.groups);
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

int scan_command(const ScanArguments& given) {
  if (given.list) {
    print(scan::list_scenes());
    return static_cast<int>(ExitCode::ok);
  }
  if (given.scene.empty()) throw Error("scan: SCENE is needed (ilot scan --list)", ExitCode::usage);
  const scan::Scene& scene = scan::find_scene(given.scene);
  scan::ScanRequest request = make_request(given, scene);
  check_output(given);
  ConsoleProgress console(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  Progress& progress = console.get();
  progress.begin_stage("scan", given.points.value_or(0));
  request.written = [&](std::uint64_t points) { progress.advance(points); };
  scan::ScanCounts counts;
  with_threads(given.threads > 0 ? given.threads : hardware_threads(), [&] { counts = scene.scan(request); });
  progress.end_stage();
  progress.note(summary_text(given.output, counts));
  if (!scene.groups.empty()) progress.note("drawn from distributions.csv, sha256 " + scan::distributions_hash());
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_scan_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("scan", "Makes a point cloud with exact truth: a virtual scanner");
  auto given = std::make_shared<ScanArguments>();
  command->add_option("SCENE", given->scene, "one of --list")->option_text(" ");
  command->add_option("-o,--output", given->output, "point cloud to write; NAME.truth.json goes beside it [none]")
      ->option_text("FILE");
  command->add_option("--points", given->points, "how many; --list tells how each scene meets it [by the scene]")
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
  command->footer("Example: ilot scan district -o town.las --points 1000000 --set scene.density=20");
  command->callback([given, &action] { action = [given] { return scan_command(*given); }; });
}

}  // namespace ilot
