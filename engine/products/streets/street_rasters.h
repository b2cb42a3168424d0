// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/cloud/cloud_info.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

// Writes the layers of a street as GeoTIFFs, north up: range, accumulation, ground, artefacts. A layer is one file
// where the raster has at most kMostTilesOfSheet tiles in both directions. A larger raster is cut into sheets of that
// size, at multiples of it on the lattice of tiles. Sheets without a point are left out. The others are cut down to
// their tiles and numbered (range_1.tif, range_2.tif), and range.vrt shows them as one image. There is no range.vrt
// where it would have 2^31 pixels in one direction, which happens where points are farther apart than the Earth is
// wide. So the directory of a file has at most a megabyte, and regions far from all others cost only the space of their
// own tiles.
constexpr std::int64_t kMostTilesOfSheet = 128;  // 65,536 pixels: 3.3 km at 5 cm
void write_street_rasters(const StreetTiles& tiles, const std::filesystem::path& folder, const Crs& crs);

}  // namespace ilot
