// SPDX-License-Identifier: Apache-2.0
// Computes a tile of a street's raster again, with its segmentation.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/model/layer.h"
#include "engine/products/streets/make_streets.h"
#include "engine/replay/kept_run.h"
#include "engine/replay/picture.h"

namespace ilot {

// All intermediate results of a tile.
struct TileReplay {
  std::size_t tile = 0;
  PointWindow window;                    // on the lattice of tiles
  std::map<std::string, Image> images;   // by layer, as last written; rows from the south
  StreetSteps steps;                     // of the whole street
  std::vector<std::string> differences;  // from what the run wrote of the street
};

// The result in a tile depends on the whole raster (which zone is the ground), so the whole street is computed again.
// `id` is "ROW,COLUMN" or "at:E,N". Throws a usage Error when the run has no such tile.
TileReplay replay_tile(const KeptRun& run, const std::string& id, Progress& progress);

// Writes a GeoTIFF for every layer to folder/layers.
void write_images(const TileReplay& tile, const Crs& crs, const std::filesystem::path& folder);

// Returns the tile, its object candidates and the objects.
std::vector<Layer> layers_of(const TileReplay& tile);

std::vector<Picture> pictures_of(const TileReplay& tile);

// Returns names, places and sizes of the tiles of a run's street.
std::vector<std::string> tiles_to_replay(const Store& store, const StreetsSettings& settings,
                                         const PassContext& context);

}  // namespace ilot
