// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "tools/ilot/commands.h"
#include "tools/render/render_cloud.h"

namespace ilot {
namespace {

struct RenderArguments {
  std::string input, output, view = "top";
  double azimuth = 30;
  std::vector<double> bounds;
  render::RenderOptions options;
};

bool is_png_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".png";
}

int render_command(RenderArguments given) {
  if (given.input.empty() || given.output.empty())
    throw Error("render: INPUT and -o FILE are needed (ilot render --help)", ExitCode::usage);
  if (!is_png_name(given.output))
    throw Error(given.output + ": pictures are written as PNG; give the file a name that ends in .png",
                ExitCode::usage);
  const double elevation = given.view == "top" ? 90 : given.view == "oblique" ? 40 : 0;
  given.options.view = {given.view == "top" ? 0 : given.azimuth, elevation};
  if (const auto& b = given.bounds; !b.empty()) {
    if (b.size() != 4 || !(b[0] < b[2] && b[1] < b[3]))
      throw Error("--bounds: write X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1", ExitCode::usage);
    given.options.bounds = {b[0], b[1], b[2], b[3]};
  }
  render::write_png(render::render_cloud(given.input, given.options), given.output);
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("render", "Draws a picture of a point cloud");
  auto given = std::make_shared<RenderArguments>();
  command->add_option("INPUT", given->input, "a point cloud")->option_text(" ");
  command->add_option("-o,--output", given->output, "picture to write (PNG) [none]")->option_text("FILE");
  command->add_option("--by", given->options.by, "class, height, intensity, rgb or an extra-byte field [class]")
      ->option_text("WHAT");
  command->add_option("--view", given->view, "top, oblique or side [top]")
      ->option_text("VIEW")
      ->check(CLI::IsMember({"top", "oblique", "side"}));
  command->add_option("--azimuth", given->azimuth, "degrees from north the eye looks to, not for top [30]")
      ->option_text("DEG")
      ->check(CLI::Range(-360.0, 360.0));
  command->add_option("--size", given->options.size, "pixels of the longer side [1600]")
      ->option_text("N")
      ->check(CLI::Range(16, 16384));
  command->add_option("--bounds", given->bounds, "only this part, in the units of the cloud [all]")
      ->option_text("X0,Y0,X1,Y1")
      ->delimiter(',');
  command->footer("Example: ilot render out/points/town.las -o town.png --by plane_id --view oblique");
  command->callback([given, &action] { action = [given] { return render_command(*given); }; });
}

}  // namespace ilot
