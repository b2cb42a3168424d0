// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/layers/raster_file.h"

namespace ilot {

// A file of a mosaic, in the folder of the mosaic, and where it is: pixels from the upper left corner of the whole.
struct MosaicPart {
  std::string file;
  std::int64_t x = 0, y = 0;
  std::uint32_t width = 0, height = 0;
};

// Files that lie side by side as one raster: GDAL's virtual format (.vrt), which QGIS opens like a GeoTIFF. Pixels of
// no part read as nodata.
void write_raster_mosaic(const std::filesystem::path& path, const RasterPlace& place, RasterValue value, double nodata,
                         const Crs& crs, const std::vector<MosaicPart>& parts);

}  // namespace ilot
