// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/scan_command.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "tools/scan/district_file.h"
#include "tools/scan/district_scan.h"

namespace ilot {
namespace {

struct ScanOptions {
  std::string scene, output;
  std::optional<std::uint64_t> points;
  std::uint64_t seed = 0;
  int threads = 0;
  std::vector<std::string> settings;
  bool list = false;
};

std::string list_scenes() {
  std::string text = "district   a town of houses under flat, gable and hip roofs, seen from the air\n";
  for (const scan::SceneOption& option : scan::district_options())
    text += fmt::format("  {:<17} [{} {}] {} ({} to {})\n", option.key, option.standard, option.unit,
                        option.help, option.low, option.high);
  return text;
}

void run_scan(const ScanOptions& options) {
  if (options.list) {
    std::cout << list_scenes();
    return;
  }
  if (options.scene != "district")
    throw Error(fmt::format("scene \"{}\" is not known: `ilot scan --list` names them.", options.scene),
                ExitCode::usage);
  if (options.output.empty()) throw Error("scan needs a file to write: -o FILE.las.", ExitCode::usage);
  scan::SceneValues values(scan::district_options());
  for (const std::string& setting : options.settings) values.set(setting);
  const scan::DistrictScan plan = scan::plan_district(values, options.seed, options.points);
  scan::ScanSummary summary;
  with_threads(options.threads > 0 ? options.threads : hardware_threads(),
               [&] { summary = scan::write_district(plan, options.output); });
  std::cout << fmt::format("{}: {} points, {} buildings, {} planes\n", options.output, summary.points,
                           summary.buildings, summary.planes);
}

}  // namespace

void add_scan_command(CLI::App& app) {
  auto options = std::make_shared<ScanOptions>();
  CLI::App* command = app.add_subcommand("scan", "Makes a cloud with exact truth: a virtual scanner");
  command->add_option("scene", options->scene, "Scene: district");
  command->add_option("-o,--output", options->output,
                      "File to write; the truth goes to NAME.truth.json beside it");
  command->add_option("--points", options->points, "Number of points; chooses the area at the given density")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000'000}));
  command->add_option("--seed", options->seed, "Another seed, another town [0]");
  command->add_option("--threads", options->threads, "Threads [all]; the file does not depend on it")
      ->check(CLI::Range(1, 1024));
  command->add_option("--set", options->settings, "scene.key=value; `ilot scan --list` shows the keys")
      ->take_all();
  command->add_flag("--list", options->list, "Lists scenes and what can be set about them");
  command->footer("Example: ilot scan district -o town.las --points 1000000 --set scene.density=20");
  command->callback([options] { run_scan(*options); });
}

}  // namespace ilot
