// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tileset.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/model/building_geometry.h"
#include "engine/pass/stop.h"
#include "engine/version.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kThinnest = 0.01;  // metres of a volume along any axis: a flat one has no inside

// The box of all that the tile and its children show: its middle and the halves of its axes.
Json volume_of(const Box3<Vec3>& box) {
  const Vec3 middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
  // Derived: vertices are float32 within 16 km, which rounds them by less than a millimetre.
  constexpr double kRounding = 1e-3;
  const auto half_of = [](double size) { return std::max(kThinnest, size) + kRounding; };
  return {{"box", {middle.x, middle.y, middle.z, half_of(half.x), 0, 0, 0, half_of(half.y), 0, 0, 0, half_of(half.z)}}};
}

std::string name_of(std::size_t tile) {
  return "tiles/" + std::to_string(tile) + ".glb";
}

Json tile_json(const std::vector<ModelTile>& tiles, std::size_t number) {
  const ModelTile& tile = tiles[number];
  Json json{{"boundingVolume", volume_of(tile.box)}, {"geometricError", tile.missing_m}};
  if (number == 0) json["refine"] = "ADD";
  if (!tile.items.empty()) json["content"]["uri"] = name_of(number);
  for (const std::uint32_t child : tile.children) json["children"].push_back(tile_json(tiles, child));
  return json;
}

}  // namespace

Tileset::Tileset(const std::filesystem::path& folder, const ExportFrame& frame, double geoid_m)
    : folder_(folder), frame_(frame), geoid_m_(geoid_m), placement_(frame, geoid_m) {
  std::filesystem::create_directories(folder / "tiles");
}

void Tileset::add(const BuildingModel& building) {
  const Building* solid = finest_solid(building.levels);
  if (solid) add_model(tile_model(building, *solid, placement_, frame_.metres_per_unit));
}

void Tileset::add(const StreetObject& object) {
  add_model(tile_model(object, placement_, frame_.metres_per_unit));
}

void Tileset::add_model(TileModel model) {
  if (model.mesh.triangles.empty()) return;
  TileItem item{Box3<Vec3>::none(), static_cast<std::uint32_t>(model.mesh.triangles.size())};
  for (const Vec3& v : model.mesh.vertices) item.box.add(v);
  items_.push_back(item);
  models_.push_back(std::move(model));
}

Json Tileset::asset() const {
  Json extras{{"crs", frame_.crs_name},
              {"origin", {frame_.origin.x, frame_.origin.y, frame_.origin.z}},
              {"metres_per_unit", frame_.metres_per_unit}};
  if (on_earth()) {
    extras["placed"] = "every vertex by PROJ to EPSG:4978";
    extras["added_to_heights_m"] = geoid_m_;
  } else {
    extras["placed"] = "not on the earth: the coordinate system is unknown; metres from the origin, east, north, up";
  }
  return {{"version", "1.1"}, {"generator", "ilot " + version()}, {"extras", {{"ilot", extras}}}};
}

void Tileset::finish() {
  const std::vector<ModelTile> tiles = tile_tree(items_);
  if (tiles.empty())
    throw Error("there is no building with a solid and no object of a street, so there is nothing for 3dtiles to show",
                ExitCode::usage);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<const TileModel*> shown;
    for (const std::uint32_t item : tiles[i].items) shown.push_back(&models_[item]);
    const std::filesystem::path path = folder_ / name_of(i);
    if (!shown.empty()) write_whole_file(path, tile_content(shown, path.string()));
  }
  Json root = tile_json(tiles, 0);
  if (on_earth()) root["transform"] = placement_.to_earth();
  const Json whole{
      {"asset", asset()}, {"geometricError", norm(tiles[0].box.max - tiles[0].box.min)}, {"root", std::move(root)}};
  write_whole_file(folder_ / "tileset.json", whole.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace ilot
