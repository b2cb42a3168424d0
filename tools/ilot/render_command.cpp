// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/render_command.h"

#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "tools/render/render_cloud.h"

namespace ilot {
namespace {

struct RenderArguments {
  std::string input, output, view = "top";
  double azimuth = 30;
  std::vector<double> bounds;
  render::RenderOptions options;
};

void run_render(RenderArguments& arguments) {
  const double elevation = arguments.view == "top" ? 90 : arguments.view == "oblique" ? 40 : 0;
  arguments.options.view = {arguments.view == "top" ? 0 : arguments.azimuth, elevation};
  if (const auto& b = arguments.bounds; !b.empty()) {
    if (b.size() != 4 || !(b[0] < b[2] && b[1] < b[3]))
      throw Error("--bounds: write X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1.", ExitCode::usage);
    arguments.options.bounds = {b[0], b[1], b[2], b[3]};
  }
  render::write_png(render::render_cloud(arguments.input, arguments.options), arguments.output);
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand("render", "Draws a picture of a cloud");
  command->add_option("input", arguments->input, "Point cloud")->required();
  command->add_option("-o,--output", arguments->output, "Picture to write (PNG)")->required();
  command->add_option("--by", arguments->options.by,
                      "class, height, intensity, rgb or an extra-byte field [class]");
  command->add_option("--view", arguments->view, "top, oblique or side [top]")
      ->check(CLI::IsMember({"top", "oblique", "side"}));
  command
      ->add_option("--azimuth", arguments->azimuth, "Degrees from north the eye looks to, not for top [30]")
      ->check(CLI::Range(-360.0, 360.0));
  command->add_option("--size", arguments->options.size, "Pixels of the longer side [1600]")
      ->check(CLI::Range(16, 16384));
  command->add_option("--bounds", arguments->bounds, "Only this part: X0,Y0,X1,Y1 in the units of the CRS")
      ->delimiter(',');
  command->footer("Example: ilot render points/town.las -o town.png --by plane_id --view oblique");
  command->callback([arguments] { run_render(*arguments); });
}

}  // namespace ilot
