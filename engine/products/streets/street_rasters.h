// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/cloud/cloud_info.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

// The layers of a street as GeoTIFFs, north up: range, accumulation, ground, artefacts. One file each where the raster
// is no larger than kMostTilesOfSheet tiles in both directions. A larger one is cut into sheets of that size, at
// multiples of it on the lattice of tiles; sheets without a point are left out, the others are cut down to their tiles
// and numbered: range_1.tif, range_2.tif, and range.vrt that shows them as one (not where it would have 2^31 pixels in
// a direction, as points do that are farther apart than the Earth is wide). So no file has a directory of more than a
// megabyte, and what is far from all else costs the place of its own tiles.
constexpr std::int64_t kMostTilesOfSheet = 128;  // 65,536 pixels: 3.3 km at 5 cm
void write_street_rasters(const StreetTiles& tiles, const std::filesystem::path& folder, const Crs& crs);

}  // namespace ilot
