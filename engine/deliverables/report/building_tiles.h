// SPDX-License-Identifier: Apache-2.0
// The shapes of buildings for the viewer: in the page where they are few, else in script files beside it, cut by place.
#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/deliverables/report/scene_buildings.h"

namespace ilot {

struct BuildingTiles {
  std::string outlines;          // of all buildings on the ground, in the order of rows: rings, corners in centimetres
  nlohmann::ordered_json about;  // of each tile: name, box in metres, number of buildings, and its file if it has one
  std::string elements;          // the tiles that are in the page
  std::uint64_t bytes_beside = 0;
};

// Sorts the buildings by place (Morton order of their middles) and packs them, up to 512 KiB a tile: for each its row,
// then its shape. Beyond 8 MiB of shapes, tiles are written to folder/report-tiles/NAME.js, which a browser may load
// from a folder. Older tiles there are removed.
BuildingTiles write_building_tiles(const std::filesystem::path& folder, const std::vector<BuildingRow>& rows);

// Removes the tiles of an older report, and their folder when nothing else is in it.
void remove_building_tiles(const std::filesystem::path& folder);

}  // namespace ilot
