// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/compare/facades/truth_facades.h"
#include "engine/deliverables/pages/facade_files.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/error.h"
#include "engine/proof/point_stream.h"
#include "engine/settings/settings.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/render/colours.h"

namespace ilot {
namespace {

struct DrawArguments {
  std::vector<std::string> inputs;
  std::string output, layers = "ilot";
  FacadeDrawingParams drawing;
  SectionRequests sections;
  std::string cloud, frame, language = "en";
};

constexpr std::size_t kBatch = 1u << 16;  // points

render::ColourRange colours_of(const std::string& cloud) {
  const auto reader = open_cloud(cloud);
  const RecordLayout& layout = reader->info().layout;
  render::ColourRange range;
  if (rgb_offset(layout.point_format))
    for_each_record(*reader, [&](const std::byte* record) {
      render::note_colour({record, layout.record_length}, layout, range);
    });
  return range;
}

// Returns a source of the points of a cloud, which opens the cloud anew each time. Without colours, the intensity gives
// a grey.
PointSource points_of(const std::string& cloud) {
  return [cloud, range = colours_of(cloud)](const Box3<Vec3>&,
                                            const std::function<void(std::span<const ImagePoint>)>& take) {
    const auto reader = open_cloud(cloud);
    const RecordLayout layout = reader->info().layout;
    const render::Colouring colour =
        render::colouring(rgb_offset(layout.point_format) ? "rgb" : "intensity", layout, range);
    std::vector<ImagePoint> batch;
    for_each_record(*reader, [&](const std::byte* record) {
      batch.push_back({position_of(record, layout), colour({record, layout.record_length})});
      if (batch.size() < kBatch) return;
      take(batch);
      batch.clear();
    });
    take(batch);
  };
}

// Reads the facades of a run, or of the truth of a scene. With a frame, returns the facade of the truth at the same
// position as the one in the frame.
std::vector<Facade> facades_in(const std::string& input, const std::string& frame) {
  if (!input.ends_with(".truth.json")) return {read_facade_json(input)};
  std::vector<Facade> facades = true_facades(read_truth(input));
  if (facades.empty()) throw Error(input + ": names no elements of facades on a true plane");
  if (frame.empty()) return facades;
  std::optional<Facade> same = truth_in_frame_of(facades, read_facade_json(frame));
  if (!same) throw Error(input + ": no facade of it lies where that of " + frame + " does");
  return {std::move(*same)};
}

int draw_command(const DrawArguments& given) {
  if (given.inputs.empty()) throw Error("draw: no FACADE.json given (ilot draw --help)", ExitCode::usage);
  if (given.output.empty()) throw Error("draw: -o FOLDER is needed", ExitCode::usage);
  FacadeFilesParams params;
  params.layers = read_layers(given.layers);
  params.drawing = given.drawing;
  const auto language = std::find(kSheetLanguageNames.begin(), kSheetLanguageNames.end(), given.language);
  params.drawing.language = static_cast<SheetLanguage>(language - kSheetLanguageNames.begin());
  params.sections = given.sections;
  check_section_lines(given.sections.lines);
  std::vector<Facade> facades;
  std::set<std::uint32_t> numbers;
  for (const std::string& input : given.inputs)
    for (Facade& facade : facades_in(input, given.frame)) {
      if (!numbers.insert(facade.id).second)
        throw Error(input + ": facade " + std::to_string(facade.id) + " is given twice", ExitCode::usage);
      facades.push_back(std::move(facade));
    }
  std::error_code failed;
  std::filesystem::create_directories(given.output, failed);
  if (failed) throw Error(given.output + ": " + failed.message());
  FacadesPage page(std::filesystem::path(given.output) / "facades.html", params.layers);
  params.page = &page;
  if (!given.cloud.empty()) params.points = points_of(given.cloud);
  for (const Facade& facade : facades) {
    write_facade_files(given.output, facade, params);
  }
  page.finish();
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_draw_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("draw", "Draws facades anew: another scale, another office's layers");
  auto given = std::make_shared<DrawArguments>();
  command->add_option("FACADE", given->inputs, "facades/facade-NNN.json of a run, or SCENE.truth.json")
      ->option_text("...");
  command->add_option("-o,--output", given->output, "folder for all files of the facades and facades.html")
      ->option_text("FOLDER");
  command->add_option("--layers", given->layers, "ilot, aia, iso13567 or a mapping file [ilot]")->option_text("NAME");
  command->add_option("--scale", given->drawing.scale, "1 : N on paper [50]")
      ->option_text("N")
      ->check(CLI::Range(1.0, 10000.0));
  command->add_option("--metres-per-unit", given->drawing.metres_per_unit, "of the coordinates, 0.3048 for feet [1]")
      ->option_text("M")
      ->check(CLI::Range(0.001, 1000.0));
  command->add_option("--title", given->drawing.title, "of the sheet [Elevation]")->option_text("TEXT");
  command->add_option("--language", given->language, "of the texts: en, fr, de, nl [en]")
      ->option_text("NAME")
      ->check(CLI::IsMember({"en", "fr", "de", "nl"}));
  command->add_option("--crs-name", given->drawing.crs_name, "written beside the CRS [none]")->option_text("TEXT");
  command->add_option("--heights", given->drawing.heights, "what heights refer to [not stated]")->option_text("TEXT");
  command->add_option("--date", given->drawing.data_date, "of the scan [not stated]")->option_text("TEXT");
  command->add_option("--source", given->drawing.source, "of the points [not stated]")->option_text("TEXT");
  command->add_option("--section", given->sections.levels, "also cut at this height of the CRS, several times [none]")
      ->option_text("Z")
      ->check(CLI::Range(-1e6, 1e6));
  command
      ->add_option("--section-at", given->sections.uprights,
                   "also cut upright at this x of the drawing, several times [none]")
      ->option_text("X")
      ->check(CLI::Range(-1e4, 1e4));
  command->add_option("--section-line", given->sections.lines, "also cut upright along this line, several times [none]")
      ->option_text("X0,Y0,X1,Y1")
      ->delimiter(',');
  command->add_option("--cloud", given->cloud, "points for orthoimages and sections [none]")->option_text("FILE");
  command
      ->add_option("--frame", given->frame, "draw the truth's facade that lies where this one does, in its axes [none]")
      ->option_text("FACADE.json");
  command->footer("Example: ilot draw out/facades/facade-001.json -o sheets --layers aia --scale 100");
  command->callback([given, &action] { action = [given] { return draw_command(*given); }; });
}

}  // namespace ilot
