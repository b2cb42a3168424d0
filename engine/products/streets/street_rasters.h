// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/cloud/cloud_info.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

// Writes the layers of a street as GeoTIFFs (tile_sheets.h): range, accumulation, ground, artefacts.
void write_street_rasters(const StreetTiles& tiles, const std::filesystem::path& folder, const Crs& crs);

}  // namespace ilot
