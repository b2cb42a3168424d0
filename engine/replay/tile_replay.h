// SPDX-License-Identifier: Apache-2.0
// A tile of a street's raster, drawn and taken apart again.
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

// Everything that was found in a tile.
struct TileReplay {
  std::size_t tile = 0;
  PointWindow window;                    // on the lattice of tiles
  std::map<std::string, Image> images;   // by layer, as last written; rows from the south
  StreetSteps steps;                     // of the whole street
  std::vector<std::string> differences;  // of the street to what the run wrote
};

// What a tile shows depends on the whole raster (which zone is the ground), so all of the street is found again. `id`:
// "ROW,COLUMN" or "at:E,N". Throws a usage Error when the run had no such tile.
TileReplay replay_tile(const KeptRun& run, const std::string& id, Progress& progress);

// A GeoTIFF for every layer in folder/layers.
void write_images(const TileReplay& tile, const Crs& crs, const std::filesystem::path& folder);

// The tile, the candidates in it and the objects.
std::vector<Layer> layers_of(const TileReplay& tile);

std::vector<Picture> pictures_of(const TileReplay& tile);

// Names, places and sizes of the tiles of a run's street.
std::vector<std::string> tiles_to_replay(const Store& store, const StreetsSettings& settings,
                                         const PassContext& context);

}  // namespace ilot
