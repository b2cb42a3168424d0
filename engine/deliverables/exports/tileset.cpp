// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tileset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/deliverables/exports/subtree_file.h"
#include "engine/error.h"
#include "engine/model/building_geometry.h"
#include "engine/pass/stop.h"
#include "engine/version.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kThinnest = 0.01;  // metres of a volume along any axis: a flat one has no inside

// A box as its middle and the halves of its axes.
std::array<double, 12> volume_of(const Box3<Vec3>& box) {
  const Vec3 middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
  const auto half_of = [](double size) { return std::max(kThinnest, size) + kVertexRounding; };
  return {middle.x, middle.y, middle.z, half_of(half.x), 0, 0, 0, half_of(half.y), 0, 0, 0, half_of(half.z)};
}

// Templates of names have what names of tiles have here.
std::string name_of(const char* folder, const std::string& level, const std::string& x, const std::string& y,
                    const char* ending) {
  return std::string(folder) + "/" + level + "_" + x + "_" + y + ending;
}

std::string content_name(const ModelTile& tile) {
  return name_of("tiles", std::to_string(tile.level), std::to_string(tile.x), std::to_string(tile.y), ".glb");
}

// The square of the root with the heights of all models. Clients halve it, and the geometric error, at each level.
std::array<double, 12> root_volume(const ModelTree& tree) {
  std::array<double, 12> volume = volume_of(tree.tiles[0].box);
  const double half = tree.width / 2;
  volume[0] = tree.x + half;
  volume[1] = tree.y + half;
  volume[3] = volume[7] = half;
  return volume;
}

// The smallest whose halves are no less than what each tile leaves out: for clients that do not read the metadata.
double root_error(const ModelTree& tree) {
  double error = 0;
  for (const ModelTile& tile : tree.tiles)
    error = std::max(error, std::ldexp(tile.missing_m, static_cast<int>(tile.level)));
  return error;
}

using Place = std::array<std::uint32_t, 3>;  // level, x, y

std::map<Place, Subtree> subtrees_of(const ModelTree& tree) {
  std::map<Place, Subtree> subtrees;
  for (const ModelTile& tile : tree.tiles) {
    const std::uint32_t level = tile.level % kSubtreeLevels, mask = (1u << level) - 1;
    Subtree& own = subtrees[{tile.level - level, tile.x >> level, tile.y >> level}];
    own.tiles.push_back(
        {level, tile.x & mask, tile.y & mask, !tile.items.empty(), volume_of(tile.box), tile.missing_m});
    if (level > 0 || tile.level == 0) continue;
    constexpr std::uint32_t kBelow = (1u << kSubtreeLevels) - 1;
    subtrees[{tile.level - kSubtreeLevels, tile.x >> kSubtreeLevels, tile.y >> kSubtreeLevels}].below.push_back(
        {tile.x & kBelow, tile.y & kBelow});
  }
  return subtrees;
}

}  // namespace

Tileset::Tileset(const std::filesystem::path& folder, const ExportFrame& frame, double geoid_m)
    : folder_(folder), frame_(frame), geoid_m_(geoid_m), placement_(frame, geoid_m) {
  std::filesystem::create_directories(folder / "tiles");
  std::filesystem::create_directories(folder / "subtrees");
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

Json Tileset::whole(const ModelTree& tree) const {
  std::uint32_t levels = 0;
  for (const ModelTile& tile : tree.tiles) levels = std::max(levels, tile.level + 1);
  Json root{{"boundingVolume", {{"box", root_volume(tree)}}},
            {"geometricError", root_error(tree)},
            {"refine", "ADD"},
            {"content", {{"uri", name_of("tiles", "{level}", "{x}", "{y}", ".glb")}}},
            {"implicitTiling",
             {{"subdivisionScheme", "QUADTREE"},
              {"subtreeLevels", kSubtreeLevels},
              {"availableLevels", levels},
              {"subtrees", {{"uri", name_of("subtrees", "{level}", "{x}", "{y}", ".subtree")}}}}}};
  if (on_earth()) root["transform"] = placement_.to_earth();
  const Box3<Vec3>& box = tree.tiles[0].box;
  return {{"asset", asset()},
          {"schema", subtree_schema()},
          {"geometricError", std::max(norm(box.max - box.min), root_error(tree))},
          {"root", std::move(root)}};
}

void Tileset::finish() {
  const ModelTree tree = tile_tree(items_);
  if (tree.tiles.empty())
    throw Error("there is no building with a solid and no object of a street, so there is nothing for 3dtiles to show",
                ExitCode::usage);
  for (const ModelTile& tile : tree.tiles) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<const TileModel*> shown;
    for (const std::uint32_t item : tile.items) shown.push_back(&models_[item]);
    const std::filesystem::path path = folder_ / content_name(tile);
    if (!shown.empty()) write_whole_file(path, tile_content(shown, path.string()));
  }
  for (const auto& [place, subtree] : subtrees_of(tree))
    write_whole_file(folder_ / name_of("subtrees", std::to_string(place[0]), std::to_string(place[1]),
                                       std::to_string(place[2]), ".subtree"),
                     subtree_file(subtree));
  write_whole_file(folder_ / "tileset.json", whole(tree).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace ilot
