// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/replay.h"

#include <nlohmann/json.hpp>

#include "engine/deliverables/layers/layers_gpkg.h"
#include "engine/deliverables/solids/city_json.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/error.h"
#include "engine/replay/building_replay.h"
#include "engine/replay/cell_replay.h"
#include "engine/replay/facade_replay.h"
#include "engine/replay/tile_replay.h"
#include "engine/run/run_context.h"
#include "engine/version.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModel = "building.city.jsonl";

struct UnitName {
  std::string kind, id;
};

UnitName unit_name(const std::string& text) {
  const std::size_t colon = text.find(':');
  UnitName unit{text.substr(0, colon), colon == std::string::npos ? "" : text.substr(colon + 1)};
  if ((unit.kind != "building" && unit.kind != "facade" && unit.kind != "tile" && unit.kind != "cell") ||
      unit.id.empty())
    throw Error(
        text + ": is no unit; write building:ID, facade:N, tile:ROW,COLUMN or cell:X,Y,Z (ilot replay OUT --list)",
        ExitCode::usage);
  return unit;
}

// Ids may contain any character.
std::string folder_name(const std::string& unit) {
  std::string name;
  for (const char c : unit) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    name += plain ? c : '-';
  }
  return name;
}

void write_report(const ReplayOptions& options, std::span<const Layer> layers, const ReplayResult& result) {
  nlohmann::ordered_json report{{"unit", options.unit},
                                {"version", version()},
                                {"git_hash", git_hash()},
                                {"same_as_run", result.differences.empty()},
                                {"differences", result.differences}};
  for (const Layer& layer : layers) report["layers"][layer.name] = layer.features.size();
  for (const Picture& picture : result.pictures) report["pictures"][picture.name + ".png"] = picture.title;
  write_whole_file(result.folder / "replay.json", report.dump(2) + "\n");
}

std::vector<Layer> facade_into(const KeptRun& run, const std::string& id, Progress& progress, ReplayResult& result) {
  const FacadeReplay facade = replay_facade(run, id, progress);
  write_facade_json(result.folder / "facade.json", facade.facade);
  result.differences = differences_of(facade, run);
  result.pictures = pictures_of(facade);
  return layers_of(facade);
}

std::vector<Layer> building_into(const KeptRun& run, const std::string& id, Progress& progress, ReplayResult& result) {
  const BuildingReplay building = replay_building(run, id, progress);
  CityJsonWriter writer(result.folder / kModel, building.file);
  writer.add(building.result.levels);
  writer.finish();
  result.differences = differences_of(building, run, result.folder / kModel);
  result.pictures = pictures_of(building);
  return layers_of(building);
}

std::vector<Layer> tile_into(const KeptRun& run, const std::string& id, Progress& progress, ReplayResult& result) {
  const TileReplay tile = replay_tile(run, id, progress);
  write_images(tile, run.inputs().crs, result.folder);
  result.differences = tile.differences;
  result.pictures = pictures_of(tile);
  return layers_of(tile);
}

std::vector<Layer> cell_into(const KeptRun& run, const std::string& id, Progress& progress, ReplayResult& result) {
  const CellReplay cell = replay_cell(run, id, progress);
  result.differences = cell.differences;
  result.pictures = pictures_of(cell);
  return layers_of(cell);
}

std::vector<Layer> replay_into(const KeptRun& run, const UnitName& unit, Progress& progress, ReplayResult& result) {
  if (unit.kind == "facade") return facade_into(run, unit.id, progress, result);
  if (unit.kind == "cell") return cell_into(run, unit.id, progress, result);
  if (unit.kind == "tile") return tile_into(run, unit.id, progress, result);
  return building_into(run, unit.id, progress, result);
}

}  // namespace

ReplayResult replay(const ReplayOptions& options, Progress& progress) {
  const UnitName unit = unit_name(options.unit);
  kept_options(options.places);  // reports faults of these before anything is written
  ReplayResult result;
  result.folder = options.folder.empty() ? options.places.out / "replay" / folder_name(options.unit) : options.folder;
  const bool made = fs::create_directories(result.folder);
  try {
    const KeptRun run(options.places, result.folder / ".scratch", progress);
    const std::vector<Layer> layers = replay_into(run, unit, progress, result);
    fs::remove(result.folder / "steps.gpkg");
    write_layers(result.folder / "steps.gpkg", layers, unit.kind == "facade" ? Crs{} : run.inputs().crs);
    write_report(options, layers, result);
  } catch (...) {
    std::error_code ignored;
    if (made) fs::remove_all(result.folder, ignored);
    if (made && options.folder.empty()) fs::remove(options.places.out / "replay", ignored);  // only when it is empty
    throw;
  }
  return result;
}

std::vector<std::string> units_to_replay(const KeptRunPlaces& places) {
  const RunOptions options = kept_options(places);
  RunRecord record;
  Progress silent;
  const RunInputs inputs = open_inputs(options, silent, record);
  const InputLattice first =
      common_lattice(inputs.readers, inputs.crs.metres_per_unit, options.settings.index.finest_step);
  const IndexResult index = open_index(options.store, first);
  PassContext context = pass_context(options, inputs, options.settings.index.block_points, silent);
  context.corner = index.corner;
  std::vector<std::string> units;
  const auto add = [&](std::vector<std::string> more) { units.insert(units.end(), more.begin(), more.end()); };
  for (const std::string& product : options.products) {
    if (product == "roofs") add(buildings_to_replay(options.output, inputs.crs.metres_per_unit));
    if (product == "facades") add(facades_to_replay(options.output));
    if (product == "streets") add(tiles_to_replay(index.store, options.settings.streets, context));
  }
  if (index.store.has(0, columns::kSegment)) add(cells_to_replay(index.store, context));
  return units;
}

}  // namespace ilot
