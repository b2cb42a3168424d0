// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "engine/columns/colours_pass.h"
#include "engine/deliverables/pages/facade_files.h"
#include "engine/pass/pass.h"
#include "engine/products/facades/walls/facade_rows.h"

namespace ilot {
namespace {

constexpr std::uint32_t kImageTile = 512;  // pixels: 7 MB per thread

// The text for the title block: the names of the inputs, and the time when their files were made.
std::string source_of(const RunInputs& inputs) {
  constexpr std::size_t kNamed = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(inputs.sources.size(), kNamed); ++i) {
    const auto& [name, date] = inputs.sources[i];
    text += (i == 0 ? "" : ", ") + name + (date.empty() ? "" : " (file of " + date + ")");
  }
  if (inputs.sources.size() > kNamed) text += fmt::format(" and {} more", inputs.sources.size() - kNamed);
  return text;
}

FacadeFilesParams files_params(const Settings& settings, const RunInputs& inputs, bool coloured) {
  FacadeFilesParams p;
  p.drawing.scale = settings.facades.scale;
  p.drawing.language = settings.facades.language;
  p.drawing.metres_per_unit = inputs.crs.metres_per_unit;
  p.drawing.source = source_of(inputs);
  p.layers = preset_layers(names_of(settings.facades.layers)[static_cast<std::size_t>(settings.facades.layers)]);
  p.image.tile = kImageTile;
  p.sections = {settings.facades.sections, settings.facades.upright_sections, settings.facades.section_lines};
  if (!coloured) p.image.shade = ImageShade::relief;
  return p;
}

// Writes the column "colour", with which images are painted. Returns false where no input has colours.
bool colours_of_points(const Store& store, const RunInputs& inputs, const PassContext& context) {
  return store.has(0, columns::kColour) || colours_pass(store, inputs.readers, context);
}

// Writes several facades at once: while an image is compressed, which takes one thread, others are painted.
void write_each(const FacadesOfRun& run, const FacadeFilesParams& params, const std::filesystem::path& folder,
                const PassContext& context, Progress& progress) {
  // An image of four bytes a pixel, and its file, which grows in memory.
  const PassTask each{std::uint64_t{params.image.most_pixels} * 8, 0};
  std::atomic<std::size_t> done{0};
  run_pass(std::vector(run.found.size(), each), context.budget_bytes, [&](std::size_t i) {
    FacadeFilesParams own = params;
    own.points = points_around(run.work, run.walls[i]);
    write_facade_files(folder, run.found[i].facade, own);
    progress.unit_done(facade_name(run.found[i].facade.id), 0, ++done, run.found.size());
  });
}

// Draws each row of houses on a sheet of its own too.
void write_rows(std::span<const FoundFacade> found, const FacadesSettings& settings, const FacadeFilesParams& params,
                const std::filesystem::path& folder) {
  std::vector<Facade> facades;  // without their elements
  for (const FoundFacade& f : found) {
    Facade& place = facades.emplace_back();
    place.origin = f.facade.origin, place.right = f.facade.right, place.up = f.facade.up, place.out = f.facade.out;
    place.width_m = f.facade.width_m, place.height_m = f.facade.height_m;
  }
  RowParams of_rows;
  of_rows.gap = settings.gap, of_rows.step = settings.relief, of_rows.least_height = settings.least_height;
  of_rows.metres_per_unit = params.drawing.metres_per_unit;
  std::uint32_t number = 0;
  for (const std::vector<std::size_t>& row : facade_rows(facades, of_rows)) {
    std::vector<Facade> houses;
    for (const std::size_t i : row) houses.push_back(found[i].facade);
    write_row_files(folder, ++number, houses, params);
  }
}

}  // namespace

void write_facade_drawings(const FacadesOfRun& run, const Settings& settings, const RunInputs& inputs,
                           const PassContext& context, const std::filesystem::path& folder, Progress& progress) {
  const FacadeFilesParams params = files_params(settings, inputs, colours_of_points(run.work.store, inputs, context));
  write_each(run, params, folder, context, progress);
  write_rows(run.found, settings.facades, params, folder);
}

}  // namespace ilot
